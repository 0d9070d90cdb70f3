#include "common/error.hpp"

#include <system_error>

namespace valsalva::common {

End end_of(const std::exception_ptr& failure)
{
  try {
    std::rethrow_exception(failure);
  } catch (const CaseError& error) {
    return {kCaseErrorCode, error.what()};
  } catch (const SolverError& error) {
    return {kSolverErrorCode, error.what()};
  } catch (const IoError& error) {
    return {kIoErrorCode, error.what()};
  } catch (const std::system_error& error) {
    return {kIoErrorCode, error.what()};
  } catch (const std::exception& error) {
    return {kProgramErrorCode, std::string("a mistake of the program, please report it: ") + error.what()};
  } catch (...) {
    return {kProgramErrorCode, "a mistake of the program, please report it"};
  }
}

}  // namespace valsalva::common
