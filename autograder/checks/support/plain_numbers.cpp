#include "checks/support/plain_numbers.hpp"

#include <cctype>
#include <cstddef>
#include <string_view>

namespace mc::checks {
namespace {

bool is_digit_at(const std::string& text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

}  // namespace

std::string without_empty_signs(std::string story) {
  for (const std::string_view sign : {"-nan", "-0"}) {
    for (auto at = story.find(sign); at != std::string::npos; at = story.find(sign, at)) {
      const char before = at == 0 ? ' ' : story[at - 1];
      const auto end = at + sign.size();
      const char behind = end < story.size() ? story[end] : ' ';
      const bool is_part = std::isalnum(static_cast<unsigned char>(before)) != 0 ||
                           std::isalnum(static_cast<unsigned char>(behind)) != 0 || before == '^' ||
                           (behind == '.' && is_digit_at(story, end + 1));
      if (is_part) {
        ++at;  // "1e-05", "-0.5"
      } else {
        story.erase(at, 1);
      }
    }
  }
  return story;
}

}  // namespace mc::checks
