#include <algorithm>

#include "report/stability.h"

namespace metamer {

namespace {

std::string file_name(const std::string& group) {
    std::string name = "stability-" + group;
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

} // namespace

std::vector<StabilityPage> stability_pages(std::span<const Experiment> experiments) {
    constexpr int kColumns = 2, kWidth_px = 1800, kRow_px = 620, kHead_px = 130;
    std::vector<StabilityPage> pages;
    for (auto first = experiments.begin(); first != experiments.end();) {
        const auto last = std::find_if(first, experiments.end(),
                                       [&](const Experiment& e) { return e.group != first->group; });
        const int rows = (static_cast<int>(last - first) + kColumns - 1) / kColumns;
        Picture page = experiment_pages({first, last}, kFailsAbove, "metamer stability", kColumns, rows,
                                        kWidth_px, kHead_px + rows * kRow_px)
                           .front();
        page.title = "Where methods fail: " + first->group;
        pages.push_back({file_name(first->group), std::move(page)});
        first = last;
    }
    return pages;
}

} // namespace metamer
