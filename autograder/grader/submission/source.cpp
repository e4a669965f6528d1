#include "grader/submission/source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
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

}  // namespace

bool is_machine_fault(const std::error_code& code) {
  for (const std::errc one :
       {std::errc::too_many_files_open, std::errc::too_many_files_open_in_system,
        std::errc::not_enough_memory, std::errc::io_error, std::errc::no_space_on_device,
        std::errc::resource_unavailable_try_again}) {
    if (code == one) return true;
  }
  return false;
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
