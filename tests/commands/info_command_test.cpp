// metamer info: what the GL is, says and does.
#include "commands/command_test.h"

namespace metamer::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Info : public CommandTest {};

TEST_F(Info, TheJsonHasTheContractsKeys) {
    const json info = json_of({"info", "--json"});
    EXPECT_NE(info.at("gl_renderer").get<std::string>(), "");
    EXPECT_NE(info.at("gl_vendor").get<std::string>(), "");
    EXPECT_THAT(info.at("gl_version").get<std::string>(), testing::StartsWith("OpenGL ES "));
    EXPECT_TRUE(info.at("fragment_highp").is_boolean());
    // The floors of OpenGL ES 2.0.25: tables 6.18 and 6.20, and section 2.1.2's 10 bits of mediump.
    EXPECT_GE(info.at("fragment_mediump_bits").get<int>(), 10);
    EXPECT_GE(info.at("max_fragment_uniform_vectors").get<int>(), 16);
    EXPECT_GE(info.at("max_varying_vectors").get<int>(), 8);
    EXPECT_GE(info.at("max_texture_size_px").get<int>(), 64);
    EXPECT_TRUE(info.at("extensions").is_array());
    for (const json& used : info.at("extensions_used"))
        EXPECT_THAT(info.at("extensions"), testing::Contains(used));
}

TEST_F(Info, ExtensionsSwitchedOffAreNotUsed) {
    const Outcome outcome = metamer({"info", "--json"}, {.environment = {{"METAMER_GL_EXTENSIONS", "none"}}});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["extensions_used"], json::array());
}

TEST_F(Info, TheTextShowsTheSame) {
    const json info = json_of({"info", "--json"});
    const std::string text = output_of({"info"});
    EXPECT_THAT(text, HasSubstr("gl_renderer: " + info["gl_renderer"].get<std::string>() + "\n"));
    EXPECT_THAT(text, HasSubstr("max_fragment_uniform_vectors: " +
                                info["max_fragment_uniform_vectors"].dump() + "\n"));
    EXPECT_THAT(text, HasSubstr("extensions: " + std::to_string(info["extensions"].size()) + " "));
}

} // namespace
} // namespace metamer::test
