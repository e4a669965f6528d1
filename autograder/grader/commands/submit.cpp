// submit: writes the zip to hand in.

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/commands/command.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int submit(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab submit LAB");
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  std::vector<std::string> files;
  for (const std::string& name : lab.depends_on) files.push_back(name + ".cpp");
  files.push_back(lab.file());
  for (const std::string& file : files) {
    if (!fs::exists(context.layout.starter() / file)) {
      throw UsageError(fmt::format("there is no starter/{} to hand in", file));
    }
  }
  const fs::path zip = fs::absolute("submission.zip");
  const fs::path aside = zip.string() + ".new";
  std::vector<std::string> command{"cmake", "-E", "tar", "cf", aside.string(), "--format=zip"};
  command.insert(command.end(), files.begin(), files.end());
  const auto made = sandbox::run_process(command, {.directory = context.layout.starter()});
  if (!made.succeeded()) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    throw MachineError(fmt::format("cannot write {}: {}", zip.string(), made.errors));
  }
  fs::rename(aside, zip);
  fmt::print("{}: {}\nHand it in unchanged.\n", zip.string(), fmt::join(files, ", "));
  return 0;
}

const RegisterCommand submit_command{
    {"submit",
     "submit LAB",
     {},
     "Writes submission.zip here: your file of that lab and of the labs it depends on.\n",
     submit}};

}  // namespace
}  // namespace mc::grader
