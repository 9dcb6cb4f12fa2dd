// SPDX-License-Identifier: BSD-3-Clause
#include "report_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "interruption.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

// The distribution's Python, which has the distribution's packages.
constexpr char kPython[] = "/usr/bin/python3";

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File openTemporary() {
  File file(std::tmpfile(), std::fclose);
  if (file == nullptr) throw BadInput(std::string("no temporary file can be made, ") + std::strerror(errno));
  return file;
}

std::string contentOf(std::FILE* file) {
  std::rewind(file);
  std::string content;
  char part[1 << 16];
  for (std::size_t count = 0; (count = std::fread(part, 1, sizeof part, file)) > 0;)
    content.append(part, count);
  return content;
}

std::string lastLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// @return the exit code, -1 if it ended by a signal
int runPython(const std::string& program, const std::string& kind, std::FILE* in, std::FILE* out,
              std::FILE* err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err), STDERR_FILENO);
  std::string arguments[] = {kPython, "-B", program, kind};
  char* argv[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), arguments[3].data(),
                  nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, kPython, &actions, nullptr, argv, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw BadInput(std::string(kPython) + ": cannot be started, " + std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Beside the tool, as catkin places both, or in lib/ of the prefix whose bin/ has the tool.
fs::path programFolder() {
  const fs::path tools = fs::canonical("/proc/self/exe").parent_path();
  const fs::path beside = tools / "report";
  if (fs::is_directory(beside)) return beside;
  const fs::path in_lib = tools.parent_path() / "lib/line_plane_segmentation/report";
  if (fs::is_directory(in_lib)) return in_lib;
  throw BadInput(beside.string() + ": the report program is missing");
}

}  // namespace

nlohmann::json pathForReport(const fs::path& path) {
  const std::string name = path.string();
  return std::vector<unsigned char>(name.begin(), name.end());
}

std::string makeReport(const std::string& kind, const nlohmann::json& data) {
  const fs::path program = programFolder();
  const File in = openTemporary(), out = openTemporary(), err = openTemporary();
  const std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (std::fwrite(text.data(), 1, text.size(), in.get()) != text.size() || std::fflush(in.get()) != 0) {
    throw BadInput(std::string("a temporary file cannot be written, ") + std::strerror(errno));
  }
  std::rewind(in.get());
  const int exit_code = runPython(program.string(), kind, in.get(), out.get(), err.get());
  stopIfInterrupted();
  if (exit_code != 0) throw BadInput("the report cannot be made: " + lastLine(contentOf(err.get())));
  return contentOf(out.get());
}

}  // namespace line_plane_segmentation
