#include "judge/submission/archive.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "sandbox/descriptor.hpp"
#include "sandbox/printable.hpp"

// libarchive is tested against hostile archives, and it reports names and types before anything is
// unpacked. `unzip` and `cmake -E tar` write at once: they would have to handle links in paths, and
// lists that differ from the content.
#ifdef MC_HAVE_ARCHIVE
#include <archive.h>
#include <archive_entry.h>
#endif

namespace mc::grader {
namespace fs = std::filesystem;

bool is_ignored(const fs::path& name) {
  const std::string text = name.string();
  return text.starts_with('.') || text == "__MACOSX" || text == "build" ||
         text.starts_with("build-") || text.starts_with("cmake-build-");
}

namespace {

/// The archive's extension, ".tar.gz"; empty if it has none.
std::string_view archive_extension(std::string_view name) {
  for (const std::string_view one :
       {".zip", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".txz", ".7z", ".rar"}) {
    if (name.size() <= one.size()) continue;
    const std::string_view end = name.substr(name.size() - one.size());
    if (std::equal(end.begin(), end.end(), one.begin(), [](char a, char b) {
          return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b;
        })) {
      return end;
    }
  }
  return {};
}

}  // namespace

bool is_archive(const fs::path& file) {
  return !archive_extension(file.filename().native()).empty();
}

std::string without_archive_extension(const std::string& name) {
  return name.substr(0, name.size() - archive_extension(name).size());
}

#ifdef MC_HAVE_ARCHIVE
namespace {

/// One byte more than a compilation accepts, so that the report says that the file is too long.
constexpr std::size_t most_of_a_source = (std::size_t{1} << 20) + 1;

struct ArchiveDeleter {
  void operator()(archive* one) const { archive_read_free(one); }
};

/// The target path of an entry, below the directory; empty if it is left out.
fs::path target_of(archive_entry* entry) {
  const char* name = archive_entry_pathname_utf8(entry);
  if (name == nullptr) name = archive_entry_pathname(entry);
  if (name == nullptr || *name == '\0') return {};
  const fs::path whole = name;
  fs::path place;
  bool ignored = false;
  for (const fs::path& part : whole) {
    if (part == ".." || part.is_absolute()) {
      throw UnreadableSubmission(
          fmt::format("the archive has a path outside of itself, {}",
                      sandbox::printable_line(sandbox::shortened(name, 100))));
    }
    if (part.empty() || part == ".") continue;
    const std::string name_here = part.string();  // what systems add, not people
    ignored |= name_here == "__MACOSX" || name_here == ".git" || name_here.starts_with("._");
    place /= part;
  }
  return ignored ? fs::path() : place;
}

/// Copies at most `most` bytes of the entry into a new file; returns how many. Sets `longer` if
/// there are more; does not read the entry if `most` is 0.
std::size_t copy(archive* from, const fs::path& to, std::size_t most, bool& longer) {
  std::ofstream file(to, std::ios::binary);
  std::vector<char> buffer(std::size_t{1} << 16);
  std::size_t written = 0;
  while (most > 0 && !longer && file) {
    const la_ssize_t got = archive_read_data(from, buffer.data(), buffer.size());
    if (got < 0) throw UnreadableSubmission("the archive is damaged");
    if (got == 0) break;
    longer = written + static_cast<std::size_t>(got) > most;
    const std::size_t part = longer ? most - written : static_cast<std::size_t>(got);
    file.write(buffer.data(), static_cast<std::streamsize>(part));
    written += part;
  }
  file.close();
  if (!file) sandbox::fail("unpacking");
  return written;
}

/// False if the file system does not accept the name. Throws std::system_error if the disk is full.
bool make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error == std::errc::filename_too_long || error == std::errc::not_a_directory ||
      error == std::errc::illegal_byte_sequence || error == std::errc::file_exists) {
    return false;
  }
  if (error) throw std::system_error(error, "unpacking");
  return true;
}

bool is_possible_file(const fs::path& file) {
  constexpr std::size_t longest_name = 255;
  return file.filename().string().size() <= longest_name && !fs::is_directory(file);
}

}  // namespace

void unpack(const Unpacking& paths, const ArchiveLimits& limits) {
  // libarchive converts names to the locale's encoding; "C" loses names with an umlaut.
  static const bool has_utf8 = std::setlocale(LC_CTYPE, "C.UTF-8") != nullptr ||
                               std::setlocale(LC_CTYPE, "en_US.UTF-8") != nullptr;
  (void)has_utf8;
  const std::unique_ptr<archive, ArchiveDeleter> reading(archive_read_new());
  if (!reading) throw std::system_error(ENOMEM, std::generic_category(), "unpacking");
  archive_read_support_format_zip_seekable(reading.get());
  archive_read_support_format_tar(reading.get());
  archive_read_support_format_7zip(reading.get());
  archive_read_support_filter_gzip(reading.get());
  archive_read_support_filter_bzip2(reading.get());
  archive_read_support_filter_xz(reading.get());
  const auto damaged = [&](const char* what) {
    const int error = archive_errno(reading.get());
    if (error == EMFILE || error == ENFILE || error == ENOMEM || error == EIO) {
      throw std::system_error(error, std::generic_category(), "unpacking");
    }
    throw UnreadableSubmission(what);
  };
  constexpr std::size_t block = std::size_t{1} << 16;
  if (archive_read_open_filename(reading.get(), paths.archive.c_str(), block) != ARCHIVE_OK) {
    damaged("it is not a zip, tar or 7z archive");
  }
  std::size_t entries = 0, bytes = 0;
  for (archive_entry* entry = nullptr;;) {
    const int next = archive_read_next_header(reading.get(), &entry);
    if (next == ARCHIVE_EOF) return;
    if (next < ARCHIVE_WARN)
      damaged(entries == 0 ? "it is not a zip, tar or 7z archive" : "the archive is damaged");
    if (++entries > limits.entries) {
      throw UnreadableSubmission(
          fmt::format("the archive has more than {} entries", limits.entries));
    }
    const fs::path place = target_of(entry);
    // Too deep for any submission; a name of a thousand parts would create a thousand directories.
    if (std::distance(place.begin(), place.end()) > limits.depth) continue;
    const auto type = archive_entry_filetype(entry);
    // A link might lead to the solutions.
    if (place.empty() || (type != AE_IFREG && type != AE_IFDIR)) continue;
    const fs::path to = paths.to / place;
    if (!make_directory(type == AE_IFDIR ? to : to.parent_path())) continue;
    if (type == AE_IFDIR || !is_possible_file(to)) continue;
    const bool is_source = to.extension() == ".cpp", is_zip = is_archive(to);
    if (archive_entry_is_encrypted(entry) != 0 && (is_source || is_zip)) {
      throw UnreadableSubmission("the archive has a password");
    }
    bool longer = false;
    const std::size_t most = is_source ? most_of_a_source : is_zip ? limits.file : 0;
    bytes += copy(reading.get(), to, most, longer);
    if (longer && is_zip) fs::resize_file(to, 0);  // reported when it is opened
    const timespec times[] = {{0, UTIME_OMIT}, {archive_entry_mtime(entry), 0}};
    if (archive_entry_mtime_is_set(entry) != 0) utimensat(AT_FDCWD, to.c_str(), times, 0);
    if (bytes > limits.bytes) {
      throw UnreadableSubmission(
          fmt::format("the archive holds more than {} MB", limits.bytes >> 20));
    }
  }
}

#else

void unpack(const Unpacking&, const ArchiveLimits&) {
  throw UnreadableSubmission(
      "an archive, but this build has no libarchive: run ./lab setup, or unpack it");
}

#endif

}  // namespace mc::grader
