#include "kiosk/reason_words.h"

#include <map>

namespace metamer {

namespace {

class Speaker {
public:
    Speaker(const Words& words, const std::string& language) : words_(words), language_(language) {}

    std::string say(const Reason& reason) const {
        const std::string ground = text(key_of(reason.ground), {{"error", error(reason.error)},
                                                                {"count", std::to_string(reason.taps)},
                                                                {"pixel", pixel(reason.worst)}});
        if (!reason.rejected)
            return ground;
        return text("reason.cheaper", {{"reason", ground},
                                       {"error", error(reason.rejected->error)},
                                       {"method", method(*reason.rejected)}});
    }

private:
    std::string text(const std::string& key, const std::map<std::string, std::string>& values = {}) const {
        return words_.text(language_, key, values);
    }

    static const char* key_of(Ground ground) {
        switch (ground) {
        case Ground::asked:
            return "reason.asked";
        case Ground::constant:
            return "reason.constant";
        case Ground::table:
            return "reason.table";
        case Ground::product:
            return "reason.product";
        case Ground::taps:
            return "reason.taps";
        case Ground::thickness:
            return "reason.medium";
        case Ground::all:
            break;
        }
        return "reason.all";
    }

    std::string error(double delta_e_2000) const {
        const ToldError told = told_error(delta_e_2000);
        return text("difference.number", {{"number", words_.number(language_, told.value, told.decimals)}});
    }

    std::string method(const Reason::Rejected& rejected) const {
        return rejected.taps > 0 ? text("reason.few", {{"count", std::to_string(rejected.taps)}})
                                 : text("method." + std::string(method_name(rejected.method)));
    }

    std::string pixel(const PixelName& name) const {
        std::string material = words_.name_of(language_, "material", name.material);
        if (!name.medium.empty())
            material = text("reason.behind", {{"material", material},
                                              {"medium", words_.name_of(language_, "material", name.medium)},
                                              {"thickness", words_.number(language_, name.thickness, 1)}});
        return text("panel.title",
                    {{"material", material},
                     {"lamp", name.lamp.empty() ? text("panel.all_lamps")
                                                : words_.name_of(language_, "lamp", name.lamp)}});
    }

    const Words& words_;
    const std::string& language_;
};

} // namespace

std::string reason_words(const Reason& reason, const Words& words, const std::string& language) {
    return Speaker(words, language).say(reason);
}

} // namespace metamer
