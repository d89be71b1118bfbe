#include "viewer/ui/embedded_fonts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/io_helpers.h"

namespace aomd::ui::embedded_fonts_test {
namespace {

std::string text_of(std::span<const unsigned char> bytes) { return {bytes.begin(), bytes.end()}; }

TEST(EmbeddedFonts, AreThoseOfTheMachineThatBuiltIt) {
  for (const auto& [name, file] :
       {std::pair{"text", "/usr/share/fonts/opentype/inter/Inter-Regular.otf"},
        {"heading", "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf"},
        {"mono", "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf"}}) {
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    EXPECT_TRUE(text_of(embedded_font(name)) == test::bytes_of(file)) << name;
  }
}

TEST(EmbeddedFonts, OthersAreNone) { EXPECT_TRUE(embedded_font("small").empty()); }

}  // namespace
}  // namespace aomd::ui::embedded_fonts_test
