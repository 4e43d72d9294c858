// The shipped tour's captions stand whole on every screen.
#include <gtest/gtest.h>

#include "exhibit/load.h"
#include "overlay/layout.h"
#include "overlay/pixels.h"
#include "overlay/words.h"

namespace metamer {
namespace {

TEST(Tour, EveryCaptionFitsInEveryLanguage) {
    const Exhibit exhibit =
        load_exhibit(METAMER_SOURCE_DIR "/config/kiosk.ini", {"atlas.quantization=thesis"});
    const Words words;
    for (const ScreenSize& screen :
         {ScreenSize{640, 480, 0}, ScreenSize{800, 480, 5.2}, ScreenSize{480, 800, 5.2},
          ScreenSize{1280, 720, 0}, ScreenSize{720, 1280, 0}}) {
        Contents contents;
        contents.lamps = static_cast<int>(exhibit.kiosk.lamps.size());
        contents.languages = static_cast<int>(words.languages().size());
        contents.caption = true;
        const Layout layout = lay_out(screen, contents);
        for (const Language& language : words.languages())
            for (const TourStep& step : exhibit.kiosk.tour) {
                Widget caption;
                caption.part = Part::caption;
                caption.box = layout.caption;
                caption.text = step.caption(language.code);
                caption.right_to_left = language.right_to_left;
                EXPECT_TRUE(text_fits(caption, layout.unit_px))
                    << screen.width_px << "x" << screen.height_px << " " << caption.text;
            }
    }
}

} // namespace
} // namespace metamer
