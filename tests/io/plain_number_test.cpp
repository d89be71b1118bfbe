// Numbers that are read without std::from_chars are what it makes of them, to the last bit.

#include "core/io/plain_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <random>
#include <string>

namespace aomd::io::detail::plain_number_test {
namespace {

struct Read {
  std::ptrdiff_t length;  // 0: of another kind
  std::uint64_t bits;
  friend bool operator==(const Read&, const Read&) = default;
};

Read plain(const std::string& text) {
  double value = 0;
  const char* const end = plain_real(text.data(), text.data() + text.size(), value);
  return {end ? end - text.data() : 0, end ? std::bit_cast<std::uint64_t>(value) : 0};
}

Read usual(const std::string& text) {
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  return {end - text.data(), std::bit_cast<std::uint64_t>(value)};
}

TEST(PlainNumberTest, IsWhatFromCharsReads) {
  for (const char* text :
       {"0", "-0", "7", "-7", "0.1", "-0.1", ".5", "5.", "-.5", "0.0320270", "123456789.125", "1 2",
        "1,5", "9007199254740992", "0.000000000000000001", "4.35", "1.005"})
    EXPECT_EQ(plain(text), usual(text)) << text;
}

TEST(PlainNumberTest, LeavesOthersAlone) {
  for (const char* text :
       {"", "-", ".", "-.", "+1", "x", "nan", "inf", "0.30000000000000004", "9007199254740993",
        "0.00000000000000000001", "18446744073709551617", "1234567890.1234567891"})
    EXPECT_EQ(plain(text).length, 0) << text;
  EXPECT_EQ(plain("1e5").length, 1);  // the caller sees that the word does not end there
  EXPECT_EQ(plain("1.5d0").length, 3);
}

TEST(PlainNumberTest, IsTheNearestDouble) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200'000; ++i) {
    std::string digits = std::to_string(random() >> (random() % 64));
    if (random() % 4 != 0) digits.insert(random() % (digits.size() + 1), ".");
    if (random() % 2 == 0) digits.insert(0, "-");
    if (const Read read = plain(digits); read.length != 0) {
      ASSERT_EQ(read, usual(digits)) << digits;
    }
  }
}

TEST(PlainNumberTest, MayBeWhole) {
  const auto whole = [](const std::string& text) {
    std::int64_t value = -1;
    const char* const end = plain_integer(text.data(), text.data() + text.size(), value);
    return std::pair(end ? end - text.data() : 0, value);
  };
  EXPECT_EQ(whole("0"), std::pair(std::ptrdiff_t{1}, std::int64_t{0}));
  EXPECT_EQ(whole("-12 3"), std::pair(std::ptrdiff_t{3}, std::int64_t{-12}));
  EXPECT_EQ(whole("999999999999999999"),
            std::pair(std::ptrdiff_t{18}, std::int64_t{999999999999999999}));
  for (const char* text : {"", "-", "+1", "x", "1000000000000000000"})
    EXPECT_EQ(whole(text).first, 0) << text;
}

}  // namespace
}  // namespace aomd::io::detail::plain_number_test
