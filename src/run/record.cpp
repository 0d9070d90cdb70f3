#include "run/record.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>

#include "common/error.hpp"
#include "common/json_text.hpp"
#include "common/text_file.hpp"

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

constexpr std::size_t kRoomToEnd = 512;  // bytes more than the record of a run under way has

std::string text_of(const RunRecord& r, int ranks)
{
  return fmt::format(
      "{{\n  \"case\": {},\n  \"outcome\": {},\n  \"written\": {},\n  \"host\": {},\n  \"ranks\": {},\n  "
      "\"t_s\": {:.9g},\n"
      "  \"steps\": {},\n  \"cells\": {},\n  \"nodes\": {},\n  \"wall_s\": {:.3f},\n  \"peak_memory_mb\": "
      "{:.1f}\n}}\n",
      common::json_quoted(r.case_path), common::json_quoted(r.outcome), common::json_quoted(utc_now()),
      common::json_quoted(host_name()), ranks, r.t_s, r.steps, r.cells, r.nodes, r.wall_s, r.peak_memory_mb);
}

}  // namespace

double peak_memory_mb(const Communicator& comm)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return comm.sum(1024 * static_cast<double>(usage.ru_maxrss) / 1e6);
}

void write_run_record(const std::string& folder, RunRecord& record, const Communicator& comm)
{
  record.peak_memory_mb = peak_memory_mb(comm);
  common::on_rank_0(comm, [&] {
    const std::string path = folder + "/run.json", text = text_of(record, comm.size());
    common::write_text_file(path, text);
    if (record.outcome == "running") try {
        common::reserve_text_file(path, text.size() + kRoomToEnd);
      } catch (const IoError&) {
        std::remove(path.c_str());
        throw;
      }
  });
}

void write_failed_run_record(const std::string& folder, RunRecord record, const Communicator& comm)
{
  record.outcome = "failed";
  try {
    common::write_text_file(folder + "/run.json", text_of(record, comm.size()));
  } catch (const IoError&) {
  }
}

}  // namespace valsalva::run
