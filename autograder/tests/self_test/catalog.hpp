#pragma once
// Catalogs: files of mistakes that are compiled once. Each mistake is a namespace with the
// functions that differ from the solution's; the linker puts them in place. A catalog of attacks is
// not compiled as a whole: each section, with the starter's functions, is its own file.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::self_test {

/// A submission of the repository: a file, or one mistake or attack of a catalog.
struct Subject {
  std::filesystem::path file;
  std::string section = {};  ///< the mistake's namespace, the attack's name; empty for a whole file
};

/// A file that is named for a task, `mistakes/halton/5.1.cpp`, is a catalog.
bool is_catalog(const std::filesystem::path& file);

/// The mistakes or attacks of a catalog; of any other file, the file itself.
std::vector<Subject> subjects_in(const std::filesystem::path& file);

/// The text of an attack: what its catalog has above the first section, its section, and the
/// starter. If it defines attack(), the starter's first task calls that; else functions of the lab
/// that it defines replace the starter's. An attack that does neither is compiled without starter.
std::string attack_in(const Subject& subject, const std::string& starter);

/// The values of "// key: value" in the comment that a file or an attack begins with, or that is
/// above a mistake. Names of checks are separated by commas.
std::vector<std::string> said(const Subject& subject, const std::string& key);

/// One process at a time: the first compiles a catalog, the others wait for it.
class CatalogLock {
 public:
  explicit CatalogLock(const std::filesystem::path& slot);

 private:
  sandbox::Descriptor lock_;
};

/// A public function of the lab that the catalog has renamed. All names are mangled.
struct Definition {
  std::string function;
  std::string right;  ///< the solution's, renamed right_function
  std::string
      mistaken;  ///< that of the mistake's namespace; empty if the mistake keeps the right one
};

/// All of them for one mistake. Throws UsageError if it replaces none, or one that is not renamed.
std::vector<Definition> definitions_of(const grader::Layout& layout, const grader::Lab& lab,
                                       const std::filesystem::path& object, const Subject& subject);

/// The linker's flags that put the mistake's functions in place.
std::vector<std::string> linker_flags(const std::vector<Definition>& definitions);

/// The linker's flags with which this function aborts, and all others are right.
std::vector<std::string> linker_flags_to_abort(const std::string& function,
                                               const std::vector<Definition>& definitions);

}  // namespace mc::self_test
