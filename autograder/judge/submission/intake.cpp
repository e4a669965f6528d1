#include "judge/submission/intake.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/submission/archive.hpp"
#include "judge/submission/platform_names.hpp"
#include "judge/submission/source.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

using Files = std::map<std::string, fs::path>;  // lab name -> file

/// Limits of nesting and of the number of entries, beyond any real submission.
constexpr int deepest = 12, deepest_archive = 3;
constexpr std::size_t most_entries = 20'000;

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// The content of a directory, by name.
struct Listing {
  std::vector<fs::path> directories, archives, files, others;  ///< others: links and devices
};

Listing listing_of(const fs::path& directory) {
  std::vector<fs::directory_entry> entries;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entries.size() == most_entries) {
      throw UnreadableSubmission(fmt::format("more than {} files in one directory", most_entries));
    }
    entries.push_back(entry);
  }
  std::ranges::sort(entries);
  Listing listing;
  for (const fs::directory_entry& entry : entries) {
    const fs::file_status status = entry.symlink_status();
    auto& kind = fs::is_directory(status)       ? listing.directories
                 : !fs::is_regular_file(status) ? listing.others
                 : is_archive(entry.path())     ? listing.archives
                                                : listing.files;
    kind.push_back(entry.path());
  }
  return listing;
}

/// The first `most` characters of a text, in at most 200 bytes: it becomes a file's name.
std::string first_characters(const std::string& text, std::size_t most) {
  std::size_t count = 0, end = 0;
  for (; end < text.size(); ++end) {
    const bool begins_one = (static_cast<unsigned char>(text[end]) & 0xc0) != 0x80;
    if (begins_one && (count++ == most || end > 196)) break;
  }
  return text.substr(0, end);
}

/// What a name stands for, safe to show and to use as a file name.
std::string id_from_name(const std::string& name) {
  std::string id = sandbox::printable_line(name);
  std::ranges::replace(id, '/', '_');
  id = first_characters(id, longest_id);
  const bool is_special = id.empty() || id == "." || id == "..";
  return is_special ? "submission" : id;
}

/// Appends " (2)", " (3)", … to ids that occur before, also on a disk that ignores case.
void make_unique(std::vector<IntakeEntry>& entries) {
  std::set<std::string> taken;
  for (IntakeEntry& entry : entries) {
    std::string& id = entry.submission.label;
    const std::string plain = id;
    for (int i = 2; !taken.insert(in_lower_case(id)).second; ++i) {
      const std::string suffix = fmt::format(" ({})", i);
      id = first_characters(plain, longest_id - suffix.size()) + suffix;
    }
  }
}

/// One person's files below a directory.
class Search {
 public:
  explicit Search(const std::vector<Lab>& labs) : labs_(labs) {}

  /// Adds the files of every directory at or below `directory` that has lab files, but does not
  /// look below those.
  void look_in(const fs::path& directory, int depth = 0) {
    for (const fs::path& here : {directory, directory / "starter"}) {
      if (Files files = files_in(labs_, here); !files.empty()) {
        places.push_back(std::move(files));
        return;
      }
    }
    const Listing listing = listing_of(directory);
    for (const auto* kind : {&listing.files, &listing.archives}) {
      for (const fs::path& file : *kind) {
        if (!is_ignored(file.filename()) && is_source_or_archive(file)) {
          others.push_back(file.filename().string());
        }
      }
    }
    if (depth == deepest) return;
    for (const fs::path& below : listing.directories) {
      if (is_ignored(below.filename())) continue;
      if (left_-- == 0) {
        throw UnreadableSubmission(fmt::format("more than {} directories", most_entries));
      }
      look_in(below, depth + 1);
    }
  }

  std::vector<Files> places;
  std::vector<std::string> others;  ///< names that may have been meant: "variance (1).cpp"

 private:
  bool is_source_or_archive(const fs::path& file) const {
    const std::string name = in_lower_case(file.filename().string());
    return is_archive(file) || name.find(".c") != std::string::npos ||
           std::ranges::any_of(labs_, [&](auto& lab) { return name.starts_with(lab.name); });
  }

  const std::vector<Lab>& labs_;
  std::size_t left_ = most_entries;
};

/// The path of `file` relative to `root`; empty for the root itself.
std::string place_in(const fs::path& root, const fs::path& file) {
  const fs::path place = file.parent_path().lexically_relative(fs::canonical(root));
  return place == "." ? "" : sandbox::printable_line(place.string());
}

/// The files of all places. Throws UnreadableSubmission if a file is in two of them.
Files combined(const fs::path& root, const std::vector<Files>& places) {
  Files all;
  for (const Files& files : places) {
    for (const auto& [lab, file] : files) {
      const auto [before, is_new] = all.emplace(lab, file);
      if (is_new) continue;
      throw UnreadableSubmission(fmt::format("{} is in {} and in {}: which one counts?",
                                             file.filename().string(),
                                             place_in(root, before->second), place_in(root, file)));
    }
  }
  return all;
}

/// The name without "/" at its end; of "." and ".." the directory's.
std::string name_of(const fs::path& place) {
  const std::string name = (place / "").parent_path().filename().string();
  if (!name.empty() && name != "." && name != "..") return name;
  std::error_code unknown;
  return fs::weakly_canonical(place, unknown).filename().string();
}

class IntakeBuilder {
 public:
  explicit IntakeBuilder(const Context& context) : context_(context) {}

  void add_word(const std::string& word) {
    const auto end = word.find_last_not_of('/');
    const fs::path place = end == std::string::npos ? word : word.substr(0, end + 1);
    const std::string name = name_of(place);
    add(is_archive(place) ? without_archive_extension(name) : name, word,
        [&](IntakeEntry& entry) { open(root_of(place), entry); });
  }

  void add_class(const fs::path& place) {
    Listing listing = listing_of(root_of(place));
    const bool is_wrapped = is_archive(place) && listing.directories.size() == 1 &&
                            listing.archives.size() + listing.files.size() == 0;
    if (is_wrapped) listing = listing_of(listing.directories[0]);
    std::map<std::string, std::vector<std::pair<PlatformName, fs::path>>> people;
    std::map<std::string, int> keys;
    for (const auto* kind : {&listing.files, &listing.archives}) {
      for (const fs::path& file : *kind) {
        if (const auto named = named_by_platform(file.filename().string())) ++keys[named->key];
      }
    }
    const auto person_of = [&](const fs::path& file) {
      auto named = named_by_platform(file.filename().string());
      // Two files never share a platform's key: then "lab_12_34_ann.zip" is a name like any other.
      return named && keys[named->key] == 1 ? named : std::nullopt;
    };
    for (const fs::path& directory : listing.directories) {
      add(directory.filename().string(), directory,
          [&](IntakeEntry& entry) { open(directory, entry); });
    }
    for (const fs::path& archive : listing.archives) {
      if (const auto named = person_of(archive)) {
        people[named->person].emplace_back(*named, archive);
      } else {
        add(without_archive_extension(archive.filename().string()), archive,
            [&](IntakeEntry& entry) { open(unpacked(archive), entry); });
      }
    }
    for (const fs::path& file : listing.files) {
      if (const auto named = person_of(file)) {
        people[named->person].emplace_back(*named, file);
      } else {
        leave_out(file, "a file of no student: put it into a directory of its own");
      }
    }
    for (const auto& [person, files] : people) {
      add(person, files[0].second, [&, &all = files](IntakeEntry& entry) { collect(all, entry); });
    }
    for (const fs::path& other : listing.others) {
      add(other.filename().string(), other, [](IntakeEntry&) {
        throw UnreadableSubmission("it is a link or a device, not a directory");
      });
    }
    std::ranges::stable_sort(intake_.entries, {},
                             [](const IntakeEntry& one) { return one.submission.label; });
  }

  Intake finish() {
    make_unique(intake_.entries);
    return std::move(intake_);
  }

 private:
  /// Adds the result of `work` on `place`, or why it cannot be read.
  template <class Work>
  void add(const std::string& name, const fs::path& place, const Work& work) {
    IntakeEntry entry;
    entry.submission.label = id_from_name(name);
    entry.submission.path = place;
    try {
      work(entry);
    } catch (const std::system_error& error) {
      if (is_machine_fault(error.code())) throw;
      entry.unreadable = error.code().message();
    } catch (const std::exception& error) {
      entry.unreadable = error.what();
    }
    intake_.entries.push_back(std::move(entry));
  }

  void leave_out(const fs::path& file, const std::string& why) {
    intake_.left_out.push_back(
        fmt::format("{}: {}", sandbox::printable_line(file.filename().string()), why));
  }

  /// The directory of a word, or of an archive's content.
  fs::path root_of(const fs::path& place) {
    const fs::file_status status = fs::symlink_status(place);
    const std::string shown = sandbox::printable_line(place.string());
    if (!fs::exists(status)) throw UnreadableSubmission("no such directory: " + shown);
    if (fs::is_symlink(status)) {
      throw UnreadableSubmission(shown + " is a link: name the directory itself");
    }
    if (fs::is_directory(status)) return place;
    if (fs::is_regular_file(status) && is_archive(place)) return unpacked(place);
    throw UnreadableSubmission(shown + " is a file: name the directory it is in, or a zip");
  }

  fs::path unpacked(const fs::path& archive) {
    intake_.unpacked.push_back(std::make_unique<ScratchDirectory>(context_.layout));
    const fs::path to = intake_.unpacked.back()->path();
    unpack({.archive = archive, .to = to});
    return to;
  }

  /// One person's work below `root`. A folder with nothing but an archive means that archive.
  void open(fs::path root, IntakeEntry& entry) {
    for (int depth = 0;; ++depth) {
      Search search(context_.labs);
      search.look_in(root);
      std::vector<fs::path> archives = listing_of(root).archives;
      std::erase_if(archives, [](auto& path) { return is_ignored(path.filename()); });
      if (search.places.empty() && archives.size() == 1 && depth < deepest_archive) {
        root = unpacked(archives[0]);
        continue;
      }
      set_files(root, search.places, entry);
      for (const std::string& other : search.others) {
        entry.submission.others.push_back(sandbox::printable_line(other));
      }
      return;
    }
  }

  static void set_files(const fs::path& root, const std::vector<Files>& places,
                        IntakeEntry& entry) {
    entry.submission.files = combined(root, places);
    for (const auto& [lab, file] : entry.submission.files) {
      if (access(file.c_str(), R_OK) == 0) continue;
      throw UnreadableSubmission(fmt::format("{} cannot be read: {}", file.filename().string(),
                                             std::generic_category().message(errno)));
    }
    std::set<std::string> where;
    for (const auto& [lab, file] : entry.submission.files) where.insert(place_in(root, file));
    where.erase("");  // at the top
    entry.submission.found_in = fmt::format("{}", fmt::join(where, ", "));
  }

  /// One person's files among those of all: the latest attempt counts.
  void collect(const std::vector<std::pair<PlatformName, fs::path>>& files, IntakeEntry& entry) {
    std::map<std::string, std::pair<int, fs::path>> latest;  // by lab
    std::vector<fs::path> archives;
    for (const auto& [named, path] : files) {
      bool is_lab = false;
      for (const Lab& lab : context_.labs) {
        if (named.file != lab.file()) continue;
        is_lab = true;
        const auto [before, is_new] = latest.try_emplace(lab.name, named.attempt, path);
        if (!is_new && named.attempt > before->second.first) before->second = {named.attempt, path};
      }
      if (!is_lab && is_archive(path)) archives.push_back(path);
      if (!is_lab && !named.file.empty())
        entry.submission.others.push_back(sandbox::printable_line(named.file));
    }
    std::vector<Files> places;
    for (const auto& [lab, one] : latest) places.push_back({{lab, fs::canonical(one.second)}});
    if (!places.empty()) return set_files(files[0].second.parent_path(), places, entry);
    if (archives.size() > 1) throw UnreadableSubmission("several archives: which one counts?");
    if (archives.empty()) return;
    entry.submission.others.clear();
    open(unpacked(archives[0]), entry);
  }

  const Context& context_;
  Intake intake_;
};

}  // namespace

Intake take_in(const Context& context, const std::vector<std::string>& words) {
  IntakeBuilder builder(context);
  for (const std::string& word : words) builder.add_word(word);
  return builder.finish();
}

Intake take_in_class(const Context& context, const fs::path& place) {
  IntakeBuilder builder(context);
  try {
    builder.add_class(place);
  } catch (const UnreadableSubmission& error) {
    throw UsageError(error.what());
  }
  return builder.finish();
}

Intake take_in_one(const Context& context, const fs::path& place) {
  Intake intake = take_in(context, {place.string()});
  if (!intake.entries[0].unreadable.empty()) throw UsageError(intake.entries[0].unreadable);
  return intake;
}

}  // namespace mc::grader
