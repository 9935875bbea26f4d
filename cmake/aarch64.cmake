# Toolchain: Debian's cross compiler for 64-bit ARM, with libraries that script/aarch64-libraries has unpacked
# into STURNUS_AARCH64; what is built runs by qemu-aarch64.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STURNUS_AARCH64)
set(CMAKE_FIND_ROOT_PATH ${STURNUS_AARCH64})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Headers alone are the same on every machine: the host's are taken where there are no others.
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
