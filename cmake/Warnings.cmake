# Compiler options of every target of the project.
function(valsalva_compile_options target)
  # maybe-uninitialized: GCC 12 reports its own AVX-512 intrinsics inside Eigen.
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Wno-maybe-uninitialized
    -fno-math-errno -fno-trapping-math -fopenmp-simd)
  target_compile_definitions(${target} PRIVATE OMPI_SKIP_MPICXX=1)
  if(VALSALVA_NATIVE)
    target_compile_options(${target} PRIVATE -march=native)
  endif()
  if(VALSALVA_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()
