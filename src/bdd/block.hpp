// SPDX-License-Identifier: MIT
// Block: an array whose memory is charged to a Budget. All memory that grows with the decision diagrams is allocated as
// Blocks, so that the memory limit is exact. If growing a block would exceed the limit, or if the system refuses
// memory, the block is unchanged and an error is returned.
//
// A block is resized in place or moved as a unit. Moving a large block does not copy its memory, because the operating
// system remaps the pages.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

namespace grafverif::bdd {

/// The memory limit and the current memory use, in bytes.
struct Budget {
    std::uint64_t limit = 0, used = 0;

    bool charge(std::uint64_t bytes) {
        if (bytes > limit - used) return false;
        used += bytes;
        return true;
    }
};

template <class T>
class Block {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    explicit Block(Budget& budget) : budget_(budget) {}
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    ~Block() {
        std::free(data_);
        budget_.used -= size_ * sizeof(T);
    }

    T& operator[](std::size_t index) {
        assert(index < size_);
        return data_[index];
    }
    const T& operator[](std::size_t index) const {
        assert(index < size_);
        return data_[index];
    }
    T* data() { return data_; }
    std::size_t size() const { return size_; }

    /// Resizes to `size` > 0 elements. New elements are uninitialized. If the memory is not available, returns false
    /// and leaves the block unchanged.
    [[nodiscard]] bool resize(std::size_t size) {
        if (size > size_ && !budget_.charge((size - size_) * sizeof(T))) return false;
        void* const moved = std::realloc(data_, size * sizeof(T));
        if (moved == nullptr && size > size_) {
            budget_.used -= (size - size_) * sizeof(T);
            return false;
        }
        if (size < size_) budget_.used -= (size_ - size) * sizeof(T);
        if (moved != nullptr) data_ = static_cast<T*>(moved);
        size_ = size;
        return true;
    }

private:
    Budget& budget_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace grafverif::bdd
