#pragma once
/// @file
/// LIESL_SANITIZED where the address or thread sanitizer, whose malloc and mmap are their own, is
/// compiled in. GCC and Clang tell it in different ways.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIESL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LIESL_SANITIZED
#endif
#endif
