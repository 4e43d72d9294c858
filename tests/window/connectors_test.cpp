#include "window/connectors.h"

#include <gtest/gtest.h>

#include "service/temporary_folder.h"

namespace metamer {
namespace {

namespace fs = std::filesystem;

/// A folder as Linux's /sys/class/drm, with cards and render nodes between the connectors.
class ConnectorsTest : public testing::Test {
protected:
    ConnectorsTest() {
        fs::create_directory(folder_ / "card0");
        fs::create_directory(folder_ / "renderD128");
        test::write(folder_ / "version", "drm 1.1.0 20060810\n");
    }
    void set(const std::string& connector, const std::string& status) {
        fs::create_directory(folder_ / connector);
        test::write(folder_ / connector / "status", status + "\n");
    }
    Connectors connectors() const { return Connectors(folder_.path()); }

    test::TemporaryFolder folder_;
};

TEST_F(ConnectorsTest, APlugIsPulledAndPutBack) {
    set("card0-HDMI-A-1", "connected");
    const Connectors now = connectors();
    EXPECT_FALSE(now.unplugged());
    EXPECT_TRUE(now.connected());
    set("card0-HDMI-A-1", "disconnected");
    EXPECT_TRUE(now.unplugged());
    EXPECT_FALSE(now.connected());
    set("card0-HDMI-A-1", "connected");
    EXPECT_FALSE(now.unplugged());
    EXPECT_TRUE(now.connected());
}

TEST_F(ConnectorsTest, ItMayComeBackElsewhere) {
    set("card0-HDMI-A-1", "connected");
    set("card1-DP-2", "disconnected");
    const Connectors now = connectors();
    set("card0-HDMI-A-1", "disconnected");
    set("card1-DP-2", "connected");
    EXPECT_TRUE(now.unplugged());
    EXPECT_TRUE(now.connected());
}

TEST_F(ConnectorsTest, AConnectorMayGoWithItsScreen) {
    set("card0-DP-3", "connected");
    const Connectors now = connectors();
    fs::remove_all(folder_ / "card0-DP-3");
    EXPECT_TRUE(now.unplugged());
}

TEST_F(ConnectorsTest, OneMoreScreenChangesNothing) {
    set("card0-HDMI-A-1", "connected");
    set("card0-HDMI-A-2", "disconnected");
    const Connectors now = connectors();
    set("card0-HDMI-A-2", "connected");
    EXPECT_FALSE(now.unplugged());
    set("card0-HDMI-A-2", "disconnected");
    EXPECT_FALSE(now.unplugged());
}

TEST_F(ConnectorsTest, WhereNothingIsKnownNothingIsUnplugged) {
    set("card0-DSI-1", "connected");
    set("card0-Writeback-1", "unknown");
    const Connectors now = connectors();
    set("card0-DSI-1", "unknown");
    EXPECT_FALSE(now.unplugged());
    set("card0-Writeback-1", "disconnected");
    EXPECT_FALSE(now.unplugged());
}

/// What SDL 2.26 does not draw on.
TEST_F(ConnectorsTest, UnknownIsNoScreenToComeBackTo) {
    set("card0-HDMI-A-1", "connected");
    set("card0-Composite-1", "unknown");
    const Connectors now = connectors();
    set("card0-HDMI-A-1", "disconnected");
    EXPECT_TRUE(now.unplugged());
    EXPECT_FALSE(now.connected());
}

TEST_F(ConnectorsTest, WithoutTheFolderNothingIsUnplugged) {
    const Connectors now(folder_ / "none");
    EXPECT_FALSE(now.unplugged());
    EXPECT_FALSE(now.connected());
}

} // namespace
} // namespace metamer
