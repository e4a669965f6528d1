// Untrusted text, made safe to show.
#include <string>
#include <string_view>

#include "checks/support/catch.hpp"
#include "sandbox/printable.hpp"

namespace mc::tests::text {

TEST_CASE("printable text") {
  CHECK(sandbox::printable("plain, with\ttabs\nand lines") == "plain, with\ttabs\nand lines");
  CHECK(sandbox::printable("σ² ≤ ε, 漢字, 🎲") == "σ² ≤ ε, 漢字, 🎲");
  CHECK(sandbox::printable("\x1b[2J\a\r\b\x7f") == "?[2J????");
  CHECK(sandbox::printable(std::string_view("a\0b", 3)) == "a?b");
  CHECK(sandbox::printable("\xc2\x9b"
                           "31m") == "??31m");         // a control character of 8 bits
  CHECK(sandbox::printable("\xff\xfe\x80") == "???");  // not UTF-8
  CHECK(sandbox::printable("\xc3") == "?");            // truncated
  CHECK(sandbox::printable("\xe2\x82") == "??");
  CHECK(sandbox::printable("\xc0\xaf \xe0\x80\xaf") == "?? ???");  // overlong
  CHECK(sandbox::printable("\xed\xa0\x80") == "???");              // half of a surrogate pair
  CHECK(sandbox::printable("\xf4\x90\x80\x80") == "????");         // above the last code point
  CHECK(sandbox::printable("\xef\xbf\xbf") == "???");  // not a character, and invalid in XML
  CHECK(sandbox::printable("\u202e\u2066\u2028") == "?????????");  // other directions, other lines
}

TEST_CASE("no text is a command to GitHub, and marked lines begin with a bar") {
  CHECK(sandbox::printable("a ##[error]x ###[b] #[c]") == "a ##?error]x ###?b] #[c]");
  CHECK(sandbox::marked("::notice a\n\nb") == "| ::notice a\n| \n| b\n");
  CHECK(sandbox::marked("").empty());
}

TEST_CASE("shortened text") {
  CHECK(sandbox::shortened("abc", 3) == "abc");
  CHECK(sandbox::shortened("abcd", 3) == "abc …");
  CHECK(sandbox::shortened("aσσ", 4) == "aσ …");
  CHECK(sandbox::shortened("", 0).empty());
}

}  // namespace mc::tests::text
