// A case file (TOML) checked against the table of keys: every value present, of the right kind and in its
// range.
//   `extends = "../base.toml"`  starts from another file; keys of the extending file win, [[entries]] merge
//   by `name` overrides ("a.b=c")         win over the files; "element.arteries.C_ml_mmHg=1.5" reaches an
//   entry by its name
// All problems of a case are found in one go and thrown as one CaseError, each with file:line:column, the
// nearest known key and, where a unit is wrong, the right one.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/case_key.hpp"
#include "common/error.hpp"

namespace valsalva::casefile {

/// Where a key or a section was written; line 0 if nowhere.
struct CasePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One checked section or entry. Asking for a key that is not in the key table, by the wrong kind, or for an
/// optional key that is absent is a programming error: std::logic_error.
class CaseTable {
 public:
  CaseTable() = default;
  CaseTable(std::string path, std::vector<Key> keys, CasePlace place);

  double real(std::string_view key) const;
  int integer(std::string_view key) const;
  bool flag(std::string_view key) const;
  const std::string& text(std::string_view key) const;  ///< of a text or a choice
  const std::vector<double>& reals(std::string_view key) const;
  bool knows(std::string_view key) const;     ///< is it in the key table of this section or entry?
  bool has(std::string_view key) const;       ///< does it have a value, given or by default?
  bool is_given(std::string_view key) const;  ///< does the value stand in the case (not a default)?
  const CaseValue& value(std::string_view key) const;

  const std::vector<Key>& keys() const { return keys_; }
  const std::string& path() const { return path_; }  ///< "grid", "element.arteries", "" for the top
  /// A problem with a value of this table that only the physics could find, with its place.
  CaseProblem problem(std::string_view key, const std::string& message) const;
  /// Where the key was written, else where the table begins.
  CasePlace place(std::string_view key) const;
  void set(std::string_view key, CaseValue value, CasePlace place, bool given);

 private:
  std::size_t index(std::string_view key) const;
  std::string path_;
  std::vector<Key> keys_;
  CasePlace place_;
  std::vector<CaseValue> values_;
  std::vector<CasePlace> places_;
  std::vector<bool> given_;
};

class CaseFile {
 public:
  /// Reads, merges, overrides and checks. CaseError with all problems; IoError if the file cannot be opened.
  static CaseFile read(const std::string& path, const KeyTable& keys,
                       const std::vector<std::string>& overrides = {});
  /// The same from text; `name` stands for the file in messages.
  static CaseFile parse(const std::string& toml, const std::string& name, const KeyTable& keys,
                        const std::vector<std::string>& overrides = {});

  const CaseTable& section(std::string_view name) const;  ///< "" for the keys above the first header
  const std::vector<CaseTable>& tables(std::string_view name) const;  ///< the entries of [[name]], as written
  /// The entry with this name, or nullptr.
  const CaseTable* entry(std::string_view array, std::string_view name) const;
  const std::string& path() const { return path_; }
  const std::string& folder() const { return folder_; }  ///< of the case file, for paths relative to it

  /// The whole case with all defaults filled in, commented; it reads back to the same case.
  std::string resolved_toml() const;
  /// The keys whose values are not those of `earlier`, a case of the same key table, with their places here.
  std::vector<CaseProblem> differences_from(const CaseFile& earlier) const;
  /// The same error with the place of every key that is known here ("grid.finest_cm", "element.arteries",
  /// "element.arteries.C_ml_mmHg", or as the lumped layer writes them: element "arteries": C_ml_mmHg; node
  /// "ao").
  CaseError locate(const CaseError& error) const;

 private:
  void locate(CaseProblem& problem) const;
  std::string path_;
  std::string folder_;
  std::map<std::string, CaseTable, std::less<>> sections_;
  std::map<std::string, std::vector<CaseTable>, std::less<>> arrays_;
  KeyTable keys_;
};

/// `valsalva keys`: every key with unit, range, default and meaning, as a commented case file.
std::string template_toml(const KeyTable& keys);
/// `valsalva keys --markdown`: the same as tables for docs/keys.md.
std::string keys_markdown(const KeyTable& keys);

}  // namespace valsalva::casefile

namespace valsalva {
using casefile::CaseFile;
using casefile::CaseTable;
}  // namespace valsalva
