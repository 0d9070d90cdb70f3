# What `valsalva --version` prints: version, git revision, compiler, libraries.
find_package(Git QUIET)
set(VALSALVA_GIT_HASH "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${CMAKE_SOURCE_DIR} describe --always --dirty
    OUTPUT_VARIABLE git_hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE git_result)
  if(git_result EQUAL 0)
    set(VALSALVA_GIT_HASH "${git_hash}")
  endif()
endif()
configure_file("${CMAKE_SOURCE_DIR}/cmake/version.hpp.in" "${CMAKE_BINARY_DIR}/generated/valsalva_version.hpp" @ONLY)
target_include_directories(valsalva PRIVATE "${CMAKE_BINARY_DIR}/generated")
