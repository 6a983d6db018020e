// SPDX-License-Identifier: BSD-3-Clause
#include "beacon/allocations.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t counted = 0;

void* allocate(std::size_t size) noexcept {
  ++counted;
  return std::malloc(size);
}

}  // namespace

// All forms that `operator delete` below may be given memory of; the rest call these.
void* operator new(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return allocate(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept { std::free(memory); }

namespace portolan {

std::size_t allocations() { return counted; }

}  // namespace portolan
