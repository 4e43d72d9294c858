#include "methods/method.h"

#include <gtest/gtest.h>

namespace metamer {
namespace {

TEST(Method, EveryNameFindsItself) {
    for (const MethodInfo& info : kMethods) {
        EXPECT_EQ(find_method(info.name), info.method);
        EXPECT_EQ(method_name(info.method), info.name);
    }
    EXPECT_EQ(find_method("SPECTRAL"), Method::spectral);
    EXPECT_FALSE(find_method("spektral"));
}

} // namespace
} // namespace metamer
