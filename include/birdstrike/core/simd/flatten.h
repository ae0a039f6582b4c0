#pragma once

/**
 * Inlines all that a function calls, so that a loop over lanes keeps its operands in registers. Without it GCC leaves
 * the vector operations of Eigen as calls with operands in memory, at three times the cost. Nothing in a build with a
 * sanitizer: its checks of what is inlined take GCC an hour for two of these files.
 */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#  define BIRDSTRIKE_FLATTEN
#else
#  define BIRDSTRIKE_FLATTEN [[gnu::flatten]]
#endif
