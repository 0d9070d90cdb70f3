#include "common/hdf5_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "common/error.hpp"
#include "common/hdf5_id.hpp"

namespace valsalva::common {
namespace {

std::string part(const std::string& path)
{
  return path + ".part";
}

/// HDF5's own description of the innermost error of the call that last failed; the next call, be it one that
/// closes an identifier, forgets the errors.
std::string g_reason;

herr_t keep_reason(hid_t errors, void*)
{
  g_reason.clear();
  return H5Ewalk2(
      errors, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* e, void*) -> herr_t {
        if (g_reason.empty() && e->desc) g_reason = e->desc;
        return 0;
      },
      nullptr);
}

/// "; its disk has 0.2 MB left"
std::string free_space(const std::string& path)
{
  std::error_code unknown;
  const auto space = std::filesystem::space(std::filesystem::absolute(path).parent_path(), unknown);
  return unknown ? ""
                 : fmt::format("; its disk has {:.4g} MB left", 1e-6 * static_cast<double>(space.available));
}

/// Waits until the file's data, or the names in a folder, are on the disk.
bool reaches_disk(const std::string& path)
{
  const int file = ::open(path.c_str(), O_RDONLY);
  const bool done = file >= 0 && ::fsync(file) == 0;
  if (file >= 0) ::close(file);
  return done;
}

}  // namespace

Hdf5File Hdf5File::create(const std::string& path)
{
  return {path, MPI_COMM_NULL, Mode::create};
}
Hdf5File Hdf5File::create(const std::string& path, MPI_Comm comm)
{
  return {path, comm, Mode::create};
}
Hdf5File Hdf5File::open(const std::string& path)
{
  return {path, MPI_COMM_NULL, Mode::open};
}
Hdf5File Hdf5File::open(const std::string& path, MPI_Comm comm)
{
  return {path, comm, Mode::open};
}

Hdf5File::Hdf5File(const std::string& path, MPI_Comm comm, Mode mode)
    : path_(path), comm_(comm), writing_(mode == Mode::create)
{
  H5Eset_auto2(H5E_DEFAULT, keep_reason, nullptr);
  g_reason.clear();
  const Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (comm_ != MPI_COMM_NULL) {
    MPI_Comm_rank(comm_, &rank_);
    H5Pset_fapl_mpio(access, comm_, MPI_INFO_NULL);
  }
  file_ = writing_ ? H5Fcreate(part(path_).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
                   : H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access);
  try {
    require(file_ >= 0, writing_ ? "could not be created" : "could not be opened");
  } catch (...) {
    abandon();
    throw;
  }
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : path_(std::move(other.path_)),
      comm_(other.comm_),
      rank_(other.rank_),
      writing_(std::exchange(other.writing_, false)),
      file_(std::exchange(other.file_, -1))
{
}

Hdf5File::~Hdf5File()
{
  abandon();
}

void Hdf5File::abandon() noexcept
{
  // HDF5 cannot close a file to which it can no longer write, and on several ranks would wait for them: it stays
  // open. Its space is needed, by the record of the failure for one.
  if (!writing_ && file_ >= 0) H5Fclose(file_);
  file_ = -1;
  if (!std::exchange(writing_, false) || rank_ > 0) return;
  std::error_code gone;
  std::filesystem::resize_file(part(path_), 0, gone);
  std::filesystem::remove(part(path_), gone);
}

void Hdf5File::close(Durable durable)
{
  require(H5Fclose(std::exchange(file_, -1)) >= 0, "could not be completed");
  if (!writing_) return;
  const bool to_disk = rank_ == 0 && durable == Durable::yes;
  require(!to_disk || reaches_disk(part(path_)), "could not be brought to the disk");
  std::error_code failed;
  if (rank_ == 0) std::filesystem::rename(part(path_), path_, failed);
  require(!failed, "could not be renamed from " + part(path_));
  const std::string folder = std::filesystem::absolute(path_).parent_path().string();
  require(!to_disk || reaches_disk(folder), "could not be brought to the disk under its name");
  writing_ = false;
}

/// Throws on all ranks, with the reason of the first that failed, if `done` is false on one.
void Hdf5File::require(bool done, const std::string& what) const
{
  constexpr int kNone = std::numeric_limits<int>::max();
  int failed = done ? kNone : rank_;
  if (comm_ != MPI_COMM_NULL) MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm_);
  if (failed == kNone) return;
  std::array<char, 200> why{};
  g_reason.copy(why.data(), why.size() - 1);
  if (comm_ != MPI_COMM_NULL) MPI_Bcast(why.data(), static_cast<int>(why.size()), MPI_CHAR, failed, comm_);
  throw IoError(fmt::format("{}: {}{}{}{}", path_, what, why[0] ? ": " : "", why.data(),
                            writing_ ? free_space(path_) : ""));
}

void Hdf5File::create_group(const std::string& name)
{
  const Id links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Id group(H5Gcreate2(file_, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  require(group.ok(), "group " + name + " could not be created");
}

namespace {

bool put_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type, hid_t space,
                   const void* values)
{
  const Id a(H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT,
                               H5P_DEFAULT),
             H5Aclose);
  return a.ok() && H5Awrite(a, type, values) >= 0;
}

template <class T>
bool put_array(hid_t file, const std::string& object, const std::string& name, std::span<const T> values)
{
  const hsize_t n = values.size();
  const Id space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  return put_attribute(file, object, name, hdf5_type<T>(), space, values.data());
}

template <class T>
bool take_array(hid_t file, const std::string& object, const std::string& name, std::vector<T>& values)
{
  const Id a(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!a.ok()) return false;
  const Id space(H5Aget_space(a), H5Sclose);
  values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  return H5Aread(a, hdf5_type<T>(), values.data()) >= 0;
}

std::string no_attribute(const std::string& object, const std::string& name)
{
  return "attribute " + name + " of " + object + " could not be read";
}

std::string bad_attribute(const std::string& object, const std::string& name)
{
  return "attribute " + name + " of " + object + " could not be written";
}

}  // namespace

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               std::span<const std::int64_t> values)
{
  require(put_array(file_, object, name, values), bad_attribute(object, name));
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               std::span<const double> values)
{
  require(put_array(file_, object, name, values), bad_attribute(object, name));
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::string& text)
{
  const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.empty() ? 1 : text.size());
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  require(put_attribute(file_, object, name, type, space, text.c_str()), bad_attribute(object, name));
}

std::vector<std::int64_t> Hdf5File::read_ints(const std::string& object, const std::string& attribute) const
{
  std::vector<std::int64_t> values;
  require(take_array(file_, object, attribute, values), no_attribute(object, attribute));
  return values;
}

std::vector<double> Hdf5File::read_doubles(const std::string& object, const std::string& attribute) const
{
  std::vector<double> values;
  require(take_array(file_, object, attribute, values), no_attribute(object, attribute));
  return values;
}

std::string Hdf5File::read_text(const std::string& object, const std::string& attribute) const
{
  const Id a(H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  std::string text;
  bool done = a.ok();
  if (done) {
    const Id type(H5Aget_type(a), H5Tclose);
    text.resize(H5Tget_size(type));
    done = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
           H5Aread(a, type, text.data()) >= 0;
  }
  require(done, no_attribute(object, attribute));
  return text.substr(0, text.find('\0'));
}

bool Hdf5File::exists(const std::string& name) const
{
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const std::string upto = name.substr(0, end);
    if (upto != "/" && H5Lexists(file_, upto.c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

}  // namespace valsalva::common
