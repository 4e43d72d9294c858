# Toolchain: 32-bit Arm with hardware floating point (Debian's armhf: ARMv7-A, VFPv3-D16) on a Debian that has armhf's
# -dev packages beside its own (multiarch). What it builds runs under qemu-user. scripts/armhf uses it.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
# Notes on what gcc before 7 passed otherwise: nothing here was built by one. And gcc 12 for Arm sees null pointers in
# std::string's and std::vector's own code.
set(CMAKE_CXX_FLAGS_INIT "-Wno-psabi -Wno-error=null-dereference")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/arm-linux-gnueabihf/pkgconfig:/usr/share/pkgconfig)
