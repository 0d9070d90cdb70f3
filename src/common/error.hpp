// What can go wrong, one exception type per kind and exit code.
//   CaseError   (exit 2)  the case file asks for something impossible; lists every problem found
//   SolverError (exit 3)  the numbers went bad: which solve, when, and the usual remedy
//   IoError     (exit 4)  a file could not be read or written
// Thrown where found, caught once in main.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace valsalva::common {

/// One thing wrong in a case file. `line` and `column` are 0 where no place in a file is known
/// (a key given with --set, say). `message` is one sentence with what was found, what is allowed, and a
/// repair.
struct CaseProblem {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key;
  std::string message;
};

class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<CaseProblem> problems)
      : std::runtime_error(text(problems)), problems_(std::move(problems))
  {
  }
  /// One problem that is known by its key alone; the case reader adds the place.
  CaseError(const std::string& key, const std::string& message)
      : CaseError(std::vector<CaseProblem>{CaseProblem{"", 0, 0, key, message}})
  {
  }
  const std::vector<CaseProblem>& problems() const { return problems_; }

 private:
  static std::string text(const std::vector<CaseProblem>& problems)
  {
    std::string all;
    for (const CaseProblem& p : problems) {
      if (!all.empty()) all += '\n';
      if (!p.file.empty()) all += p.file + ":";
      if (p.line > 0) all += std::to_string(p.line) + ":" + std::to_string(p.column) + ":";
      if (!p.file.empty()) all += ' ';
      if (!p.key.empty()) all += p.key + ": ";
      all += p.message;
    }
    return all;
  }
  std::vector<CaseProblem> problems_;
};

class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int kProgramErrorCode = 1;
inline constexpr int kCaseErrorCode = 2;
inline constexpr int kSolverErrorCode = 3;
inline constexpr int kIoErrorCode = 4;

/// How a program ends, and what it says then.
struct End {
  int code = 0;
  std::string message;
};

/// By exception type. What the system refuses (std::system_error, as of std::filesystem) counts as an IoError.
End end_of(const std::exception_ptr& failure);

}  // namespace valsalva::common

namespace valsalva {
using common::CaseError;
using common::CaseProblem;
using common::IoError;
using common::SolverError;
}  // namespace valsalva
