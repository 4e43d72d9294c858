#include "report/context_note.h"

namespace metamer {

std::string context_note(const ChartContext& context) {
    const std::string size = context.width_px > 0 && context.height_px > 0
                                 ? std::to_string(context.width_px) + "x" + std::to_string(context.height_px)
                                 : "";
    std::string out;
    for (const std::string& part : {context.gl_renderer, size, context.date, context.command})
        if (!part.empty())
            out += (out.empty() ? "" : " · ") + part;
    return out;
}

std::string pairs_text(const ChartContext& context) {
    if (context.lamps == 0 || context.materials == 0)
        return "all pairs";
    const auto counted = [](int n, const std::string& what) {
        return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    return counted(context.lamps, "lamp") + " × " + counted(context.materials, "material");
}

} // namespace metamer
