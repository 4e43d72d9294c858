#include "kiosk/loaded.h"

#include "base/error.h"
#include "base/names.h"

namespace metamer {

Words words_of(const Exhibit& exhibit) {
    const KioskSetting& kiosk = exhibit.kiosk;
    Words words = kiosk.strings.empty() ? Words() : Words(kiosk.strings);
    if (words.language(kiosk.language).code == kiosk.language)
        return words;
    std::vector<std::string> codes;
    for (const Language& language : words.languages())
        codes.push_back(language.code);
    throw bad_input("read", kiosk.language_place,
                    "language = " + kiosk.language + " has no file in the folder of strings, which has " +
                        listed(codes) + did_you_mean(kiosk.language, codes));
}

} // namespace metamer
