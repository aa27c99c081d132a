# For ARM, 64 bits, by the distribution's compiler; what is built runs here under qemu.
# Debian: g++-aarch64-linux-gnu, qemu-user, googletest (its sources).
# SUREFOOT_SYSROOT: a folder with Debian's libraries for that machine (packaging/cross_arm64 makes one);
# without it the library alone can be built.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SUREFOOT_SYSROOT)
if(SUREFOOT_SYSROOT)
  set(CMAKE_SYSROOT ${SUREFOOT_SYSROOT})
  set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
  set(ENV{PKG_CONFIG_SYSROOT_DIR} ${SUREFOOT_SYSROOT})
  set(ENV{PKG_CONFIG_LIBDIR} ${SUREFOOT_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${SUREFOOT_SYSROOT}/usr/share/pkgconfig)
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${SUREFOOT_SYSROOT})
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
else()
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
  # Libraries are of the other machine; headers alone (Eigen) are of both.
  set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu)
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
