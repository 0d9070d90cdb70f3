#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "common/end_together.hpp"
#include "valsalva_version.hpp"

namespace valsalva::app {

int run_script(const std::string& name, std::vector<std::string> arguments)
{
  const std::string script = std::string(kSourceDir) + "/scripts/" + name;
  if (!std::filesystem::exists(script)) {
    fmt::print(stderr, "valsalva: {} is missing; it comes with the sources\n", script);
    return common::kIoErrorCode;
  }
  arguments.insert(arguments.begin(), {"python3", script});
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execv("/usr/bin/python3", words.data());
    _exit(127);
  }
  int status = 0;
  const bool ended = child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
  return ended ? WEXITSTATUS(status) : common::kIoErrorCode;
}

int draw(const std::string& name, const std::string& out_dir)
{
  if (run_script(name, {out_dir}) != 0)
    fmt::print(stderr,
               "warning: something could not be drawn; the results are complete. Draw again with "
               "/usr/bin/python3 {}/scripts/{} {}\n",
               kSourceDir, name, out_dir);
  return 0;
}

}  // namespace valsalva::app
