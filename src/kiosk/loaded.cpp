#include "kiosk/loaded.h"

#include "base/error.h"

namespace metamer {

Words words_of(const Exhibit& exhibit) {
    const KioskSetting& kiosk = exhibit.kiosk;
    Words words = kiosk.strings.empty() ? Words() : Words(kiosk.strings);
    if (words.language(kiosk.language).code != kiosk.language)
        throw bad_input("read", exhibit.place,
                        "language = " + kiosk.language + " has no file in the folder of strings");
    return words;
}

} // namespace metamer
