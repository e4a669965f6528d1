#include "judge/submission/source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "sandbox/descriptor.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

std::string size_in_words(std::uintmax_t bytes) {
  if (bytes < std::uintmax_t{10} << 20) return fmt::format("{} KB", bytes >> 10);
  if (bytes < std::uintmax_t{10} << 30) return fmt::format("{} MB", bytes >> 20);
  return fmt::format("{} GB", bytes >> 30);
}

/// As Windows writes "Unicode": a byte order mark, or two letters with a zero byte each.
bool is_utf_16(std::string_view text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
  return text.size() > 3 && text[0] != text[1] &&
         ((text[0] == 0 && text[2] == 0) || (text[1] == 0 && text[3] == 0));
}

}  // namespace

bool is_machine_fault(const std::error_code& code) {
  constexpr int faults[] = {EMFILE, ENFILE, ENOMEM, EIO, ENOSPC, EAGAIN, EDQUOT, ESTALE, EROFS};
  return std::ranges::find(faults, code.value()) != std::end(faults);
}

SourceFile read_source(const fs::path& file) {
  const std::string name = sandbox::printable_line(file.filename().string());
  const auto unreadable = [&](int error) -> SourceFile {
    const std::error_code code(error, std::generic_category());
    if (is_machine_fault(code) || error == ENOENT) {  // it existed when it was found
      throw std::system_error(code, "cannot read " + file.string());
    }
    return {{}, fmt::format("{} cannot be read: {}.", name, code.message())};
  };
  // The file must not be replaced by one of another kind before the check below.
  const int raw = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (raw < 0) return unreadable(errno);
  const sandbox::Descriptor descriptor(raw, name);
  struct stat status {};
  if (fstat(descriptor.get(), &status) != 0) return unreadable(errno);
  if (!S_ISREG(status.st_mode)) return {{}, fmt::format("{} is not a regular file.", name)};
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  const auto too_long = [&](std::uintmax_t bytes) -> SourceFile {
    return {{}, fmt::format("{} is {} long; 1 MB is the limit.", name, size_in_words(bytes))};
  };
  if (size > longest_source) return too_long(size);
  SourceFile source;
  source.text.resize(longest_source + 1);  // the file may grow meanwhile
  std::size_t length = 0;
  while (length < source.text.size()) {
    const ssize_t got =
        read(descriptor.get(), source.text.data() + length, source.text.size() - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(errno);
    if (got == 0) break;
    length += static_cast<std::size_t>(got);
  }
  if (length > longest_source) return too_long(length);
  source.text.resize(length);
  if (is_utf_16(source.text)) {
    return {{},
            fmt::format("{} is encoded in UTF-16, which compilers do not read. Save it as UTF-8.",
                        name)};
  }
  return source;
}

std::string contents_of(const std::map<std::string, fs::path>& files) {
  std::string all;
  for (const auto& [lab, file] : files) {
    const SourceFile source = read_source(file);
    const std::string& text = source.problem.empty() ? source.text : source.problem;
    all += fmt::format("{} {}{}\n", lab, source.problem.empty() ? "" : "! ", text.size());
    all += text + '\n';
  }
  return all;
}

}  // namespace mc::grader
