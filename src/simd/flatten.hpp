// Functions into which everything is inlined that they call, so that numbers stay in registers on their way through.
//
// Guarantee: only time depends on it.
#pragma once

// A sanitizer's checks in such functions take minutes to compile, and measure nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GRAZE_FLATTEN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GRAZE_FLATTEN
#endif
#endif
#ifndef GRAZE_FLATTEN
#define GRAZE_FLATTEN [[gnu::flatten]]
#endif
