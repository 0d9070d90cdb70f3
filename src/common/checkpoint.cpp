#include "common/checkpoint.hpp"

#include <fmt/format.h>

#include <array>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

constexpr const char* kFormat = "valsalva checkpoint";
constexpr std::array<std::int64_t, 1> kVersion{3};  ///< goes up when names or meanings of values change

}  // namespace

Checkpoint::Checkpoint(Hdf5File file, std::string path, bool reading)
    : file_(std::move(file)), path_(std::move(path)), reading_(reading)
{
}

Checkpoint Checkpoint::create(const std::string& path, MPI_Comm comm)
{
  Checkpoint c(Hdf5File::create(path, comm), path, false);
  c.file_.write_attribute("/", "format", kFormat);
  c.file_.write_attribute("/", "version", kVersion);
  return c;
}

Checkpoint Checkpoint::open(const std::string& path, MPI_Comm comm)
{
  Checkpoint c(Hdf5File::open(path, comm), path, true);
  if (c.file_.read_text("/", "format") != kFormat) throw IoError(path + ": not a checkpoint of Valsalva");
  const std::int64_t version = c.file_.read_ints("/", "version").at(0);
  if (version != kVersion[0])
    throw IoError(
        fmt::format("{}: format {}, but this program reads format {}; use the program that wrote it", path,
                    version, kVersion[0]));
  return c;
}

template <class T>
void Checkpoint::list(const std::string& name, std::vector<T>& values)
{
  if (reading_)
    values = file_.read<T>("/" + name);
  else
    file_.write("/" + name, {static_cast<std::int64_t>(values.size())}, std::span<const T>(values));
}

template <class T>
void Checkpoint::number(const std::string& name, T& x)
{
  std::vector<T> one{x};
  list(name, one);
  if (one.size() != 1) throw IoError(path_ + ": " + name + " is not one number");
  x = one[0];
}

template void Checkpoint::number(const std::string&, double&);
template void Checkpoint::number(const std::string&, int&);
template void Checkpoint::number(const std::string&, std::int64_t&);

void Checkpoint::operator()(const std::string& name, std::vector<int>& values)
{
  list(name, values);
}

void Checkpoint::operator()(const std::string& name, std::vector<double>& values)
{
  list(name, values);
}

void Checkpoint::operator()(const std::string& name, std::string& text)
{
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  list(name, bytes);
  text.assign(bytes.begin(), bytes.end());
}

void Checkpoint::spread(const std::string& name, std::int64_t total, const std::vector<Slab>& shares,
                        std::vector<double>& values)
{
  if (reading_)
    values = file_.read<double>("/" + name, shares);
  else
    file_.write("/" + name, {total}, std::span<const Slab>(shares), std::span<const double>(values));
}

}  // namespace valsalva::common
