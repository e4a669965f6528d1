#include "judge/judging/check_process.hpp"

#include <thread>

#include "protocol/environment.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::grader {
namespace {

/// Reads a pipe to its end in its own thread, so that the writer never waits.
class PipeReader {
 public:
  PipeReader() : ends_(sandbox::make_pipe()) {
    thread_ = std::thread([this] {
      // The typed arguments of a call can take megabytes. The output is cut exactly at the limit,
      // so that a verdict does not depend on how the pipe was read.
      constexpr std::size_t most = std::size_t{32} << 20;
      std::string some;
      bool more = true;
      while (more) {
        more = sandbox::read_available(ends_.read, some, 0);
        text_.append(some, 0, most - text_.size());
        some.clear();
      }
    });
  }
  ~PipeReader() { finish(); }
  PipeReader(const PipeReader&) = delete;

  int write_end() const { return ends_.write.get(); }
  const std::string& finish() {
    ends_.write.reset();
    if (thread_.joinable()) thread_.join();
    return text_;
  }

 private:
  sandbox::Pipe ends_;
  std::string text_;
  std::thread thread_;
};

}  // namespace

CheckProcess run_check_program(const std::filesystem::path& program, const std::string& which,
                               sandbox::ProcessOptions options) {
  PipeReader pipe;
  options.environment.emplace_back(protocol::records_variable,
                                   std::to_string(protocol::records_descriptor));
  options.descriptors.emplace_back(pipe.write_end(), protocol::records_descriptor);
  std::vector<std::string> command{program.string()};
  if (!which.empty()) command.push_back(which);
  CheckProcess process{sandbox::run_process(command, options), {}};
  process.records = protocol::records_in(pipe.finish());
  return process;
}

}  // namespace mc::grader
