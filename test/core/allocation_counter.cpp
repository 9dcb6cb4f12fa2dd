// SPDX-License-Identifier: BSD-3-Clause
#include "core/allocation_counter.h"

#include <malloc.h>

#include <cstddef>
#include <cstdlib>

namespace line_plane_segmentation {

std::atomic<long> allocations{0};
std::atomic<long> live_bytes{0};
std::atomic<long> peak_bytes{0};

}  // namespace line_plane_segmentation

namespace {

using line_plane_segmentation::allocations;
using line_plane_segmentation::live_bytes;
using line_plane_segmentation::peak_bytes;

void countLive(std::size_t bytes) {
  live_bytes += static_cast<long>(bytes);
  if (live_bytes > peak_bytes) peak_bytes = live_bytes.load();
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__
// The sanitizer has an allocator of its own, which tells of every call. GCC has no header for that.
extern "C" {

std::size_t __sanitizer_get_allocated_size(const volatile void* memory);
int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                              void (*released)(const volatile void*));

}  // extern "C"

namespace {

void countAllocation(const volatile void*, std::size_t size) {
  ++allocations;
  countLive(size);
}
void countRelease(const volatile void* memory) {
  live_bytes -= static_cast<long>(__sanitizer_get_allocated_size(memory));
}
const int kInstalled = __sanitizer_install_malloc_and_free_hooks(countAllocation, countRelease);

}  // namespace
#else
namespace {

void* counted(void* memory) {
  ++allocations;
  countLive(malloc_usable_size(memory));
  return memory;
}

void countRelease(void* memory) { live_bytes -= static_cast<long>(malloc_usable_size(memory)); }

}  // namespace

// These go before those of the C library, also for the shared libraries; operator new ends here, too.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) { return counted(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) { return counted(__libc_calloc(count, size)); }
void* realloc(void* memory, std::size_t size) {
  countRelease(memory);
  return counted(__libc_realloc(memory, size));
}
void* memalign(std::size_t alignment, std::size_t size) { return counted(__libc_memalign(alignment, size)); }
void free(void* memory) {
  countRelease(memory);
  __libc_free(memory);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? 12 : 0;  // ENOMEM
}

}  // extern "C"
#endif
