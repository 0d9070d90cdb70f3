// The times of a series of files, in the JSON that ParaView reads: fields/fields.hdf.series beside
// fields_0000.hdf, ...
//   { "file-series-version" : "1.0", "files" : [ { "name" : "fields_0000.hdf", "time" : 0.0 }, ... ] }
// Rewritten as a whole and renamed into place at every addition, so that it can be opened during a
// run. A run that continues from a checkpoint finds the entries of before and drops the later ones. Not
// collective: one rank keeps the series.
#pragma once

#include <string>
#include <vector>

namespace valsalva::ib3d {

class FileSeries {
 public:
  struct Entry {
    std::string name;  ///< relative to the folder of the series
    double time_s = 0.0;
  };

  /// Reads `path` (".../name.hdf.series") if it is there. IoError if it is there and not a series of this
  /// program.
  explicit FileSeries(std::string path);

  /// Keeps the first `count` entries and rewrites the series; IoError if there are fewer.
  void cut_to(int count);
  /// Adds a file and rewrites the series; IoError if that fails.
  void add(const std::string& name, double time_s);
  /// In order of time.
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  void write() const;
  std::string path_;
  std::vector<Entry> entries_;
};

/// "fields", 12 -> "fields_0012.hdf".
std::string numbered_file(const std::string& stem, int number);

}  // namespace valsalva::ib3d
