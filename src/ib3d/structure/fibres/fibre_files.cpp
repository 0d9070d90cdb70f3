#include "ib3d/structure/fibres/fibre_files.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "common/error.hpp"
#include "ib3d/structure/fibres/fibre_file_lines.hpp"

namespace valsalva::ib3d {

namespace {

constexpr double kZeroRestLength = 1e-9;  // cm, stands for l0 = 0

std::size_t at(int node)
{
  return static_cast<std::size_t>(node);
}

void read_vertices(const std::string& prefix, FibreNetwork& network)
{
  const FibreFileLines lines(prefix + ".vertex", 3, 3, "x y z");
  for (std::size_t n = 0; n < lines.count(); ++n)
    network.X.push_back({lines.number(n, 0), lines.number(n, 1), lines.number(n, 2)});
  network.groups.push_back(
      NodeGroup{std::filesystem::path(prefix).filename().string(), 0, network.node_count()});
}

void read_springs(const std::string& path, FibreNetwork& network)
{
  const FibreFileLines lines(path, 4, 5, "node node stiffness rest_length [type]");
  for (std::size_t n = 0; n < lines.count(); ++n) {
    const int a = lines.node(n, 0, network.node_count()), b = lines.node(n, 1, network.node_count());
    if (a == b) lines.reject(n, fmt::format("a spring cannot join node {} to itself.", a));
    const double type = lines.width(n) > 4 ? lines.number(n, 4) : 0.0;
    if (type != 0.0 && type != 1.0)
      lines.reject(
          n, fmt::format("found spring type {:.6g}, but only 0 (two-sided) and 1 (tension-only) are known.",
                         type));
    const double k = lines.non_negative(n, 2, "stiffness");
    const double l0 = std::max(lines.non_negative(n, 3, "rest length"), kZeroRestLength);
    network.springs.add(a, b, k * l0, l0, type == 1.0);
  }
}

void read_beams(const std::string& path, const std::string& lengths_path, FibreNetwork& network)
{
  const FibreFileLines lines(path, 4, 7, "node node node rigidity [curvature]");
  Beams& beams = network.beams;
  for (std::size_t n = 0; n < lines.count(); ++n) {
    const int i0 = lines.node(n, 0, network.node_count()), i1 = lines.node(n, 1, network.node_count()),
              i2 = lines.node(n, 2, network.node_count());
    if (i0 == i1 || i1 == i2 || i0 == i2) lines.reject(n, "a beam needs three different nodes.");
    for (std::size_t column = 4; column < lines.width(n); ++column)
      if (lines.number(n, column) != 0.0)
        lines.reject(n, "a preferred curvature other than 0 is not supported; beams are straight at rest.");
    const double k = lines.non_negative(n, 3, "bending rigidity");
    const double l =
        0.5 * (norm(network.X[at(i1)] - network.X[at(i0)]) + norm(network.X[at(i2)] - network.X[at(i1)]));
    if (l == 0.0) lines.reject(n, "the three nodes of this beam lie in one point.");
    beams.add({i0, i1, i2}, k * l * l * l, l, l);
  }
  if (!std::filesystem::exists(lengths_path)) return;
  const FibreFileLines lengths(lengths_path, 2, 2, "l1 l2");
  if (lengths.count() != lines.count())
    throw IoError(fmt::format("{}: holds {} lines, but {} has {} beams.", lengths_path, lengths.count(), path,
                              lines.count()));
  for (std::size_t n = 0; n < lengths.count(); ++n) {
    if (lengths.number(n, 0) <= 0.0 || lengths.number(n, 1) <= 0.0)
      lengths.reject(n, "the two lengths of a beam must be positive.");
    beams.l1[n] = lengths.number(n, 0);
    beams.l2[n] = lengths.number(n, 1);
    beams.rigidity[n] = lines.number(n, 3) * std::pow(0.5 * (beams.l1[n] + beams.l2[n]), 3);
  }
}

void read_targets(const std::string& path, FibreNetwork& network)
{
  const FibreFileLines lines(path, 2, 3, "node stiffness [damping]");
  for (std::size_t n = 0; n < lines.count(); ++n) {
    const int i = lines.node(n, 0, network.node_count());
    if (lines.width(n) > 2 && lines.number(n, 2) != 0.0)
      lines.reject(n, "damping of target points is not supported; leave it out or write 0.");
    network.tethers.add(i, lines.non_negative(n, 1, "stiffness"), network.X[at(i)]);
  }
}

/// Runs `read` and keeps its complaint, so that every file has its say.
template <class Read>
void collect(std::vector<CaseProblem>& problems, Read read)
{
  try {
    read();
  } catch (const CaseError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
}

std::ofstream open(const std::string& path)
{
  std::ofstream file(path);
  if (!file) throw IoError(fmt::format("{}: cannot be opened for writing.", path));
  return file;
}

void finish(std::ofstream& file, const std::string& path)
{
  file.close();
  if (!file) throw IoError(fmt::format("{}: writing failed; is the disk full?", path));
}

template <class PrintLine>
void write(const std::string& path, std::size_t count, PrintLine print_line)
{
  std::ofstream file = open(path);
  fmt::print(file, "{}\n", count);
  for (std::size_t n = 0; n < count; ++n) print_line(file, n);
  finish(file, path);
}

}  // namespace

FibreNetwork read_fibre_files(const std::string& prefix)
{
  FibreNetwork network;
  read_vertices(prefix, network);
  std::vector<CaseProblem> problems;
  const auto exists = [&](const char* ending) { return std::filesystem::exists(prefix + ending); };
  if (exists(".spring")) collect(problems, [&] { read_springs(prefix + ".spring", network); });
  if (exists(".beam"))
    collect(problems, [&] { read_beams(prefix + ".beam", prefix + ".beam_lengths", network); });
  if (exists(".target")) collect(problems, [&] { read_targets(prefix + ".target", network); });
  if (!problems.empty()) throw CaseError(problems);
  return network;
}

void write_fibre_files(const FibreNetwork& network, const std::string& prefix)
{
  const Tethers& tethers = network.tethers;
  for (std::size_t n = 0; n < tethers.node.size(); ++n)
    if (!(tethers.target[n] == network.X[at(tethers.node[n])]))
      throw IoError(
          fmt::format("{}.target: node {} is tethered to another place than its start, which these files "
                      "cannot express.",
                      prefix, tethers.node[n]));
  write(prefix + ".vertex", network.X.size(), [&](std::ofstream& file, std::size_t n) {
    const Vec3& x = network.X[n];
    fmt::print(file, "{:.17g} {:.17g} {:.17g}\n", x[0], x[1], x[2]);
  });
  const Springs& springs = network.springs;
  write(prefix + ".spring", springs.a.size(), [&](std::ofstream& file, std::size_t n) {
    fmt::print(file, "{} {} {:.17g} {:.17g} {}\n", springs.a[n], springs.b[n],
               springs.stiffness[n] / springs.rest_length[n], springs.rest_length[n],
               springs.tension_only[n]);
  });
  const Beams& beams = network.beams;
  write(prefix + ".beam", beams.x0.size(), [&](std::ofstream& file, std::size_t n) {
    fmt::print(file, "{} {} {} {:.17g}\n", beams.x0[n], beams.x1[n], beams.x2[n],
               beams.rigidity[n] / std::pow(0.5 * (beams.l1[n] + beams.l2[n]), 3));
  });
  write(prefix + ".beam_lengths", beams.x0.size(), [&](std::ofstream& file, std::size_t n) {
    fmt::print(file, "{:.17g} {:.17g}\n", beams.l1[n], beams.l2[n]);
  });
  write(prefix + ".target", tethers.node.size(), [&](std::ofstream& file, std::size_t n) {
    fmt::print(file, "{} {:.17g}\n", tethers.node[n], tethers.stiffness[n]);
  });
}

}  // namespace valsalva::ib3d
