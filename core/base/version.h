#pragma once
// The version of the library whose headers these are, for C too. CMakeLists.txt reads it from here.

#define AOMD_VERSION_MAJOR 0
#define AOMD_VERSION_MINOR 1
#define AOMD_VERSION_PATCH 0
/// 10203 for 1.2.3: what #if can compare.
#define AOMD_VERSION_NUMBER \
  (AOMD_VERSION_MAJOR * 10000 + AOMD_VERSION_MINOR * 100 + AOMD_VERSION_PATCH)
