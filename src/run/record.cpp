#include "run/record.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "common/error.hpp"
#include "common/json_text.hpp"

namespace valsalva::run {

namespace {

std::string host_name()
{
  char name[256] = "unknown";
  gethostname(name, sizeof name - 1);
  return name;
}

std::string utc_now()
{
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

}  // namespace

double peak_memory_mb(const Communicator& comm)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return comm.sum(1024 * static_cast<double>(usage.ru_maxrss) / 1e6);
}

void write_run_record(const std::string& folder, const RunRecord& r, const Communicator& comm)
{
  const double memory = peak_memory_mb(comm);
  bool failed = false;
  if (comm.is_rank_0()) {
    const std::string path = folder + "/run.json", part = path + ".part";
    std::ofstream(part) << fmt::format(
        "{{\n  \"case\": {},\n  \"outcome\": {},\n  \"written\": {},\n  \"host\": {},\n  \"ranks\": {},\n  "
        "\"t_s\": {:.9g},\n"
        "  \"steps\": {},\n  \"cells\": {},\n  \"nodes\": {},\n  \"wall_s\": {:.3f},\n  \"peak_memory_mb\": "
        "{:.1f}\n}}\n",
        common::json_quoted(r.case_path), common::json_quoted(r.outcome), common::json_quoted(utc_now()),
        common::json_quoted(host_name()), comm.size(), r.t_s, r.steps, r.cells, r.nodes, r.wall_s, memory);
    std::error_code error;
    std::filesystem::rename(part, path, error);
    failed = static_cast<bool>(error);
  }
  if (comm.any(failed)) throw IoError("cannot write '" + folder + "/run.json'; check the free space");
}

}  // namespace valsalva::run
