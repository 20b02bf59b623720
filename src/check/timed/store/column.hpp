// SPDX-License-Identifier: MIT
// Column: a vector of data about states, indexed by the number of the state. The vector allocates memory in chunks.
// Therefore growth never copies elements and does not double the peak memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace grafverif::timed {

/// A vector that never moves its elements.
template <class T>
class Column {
public:
    static constexpr std::size_t shift = 12, chunk = std::size_t{1} << shift;

    T& operator[](std::size_t i) { return chunks_[i >> shift][i & (chunk - 1)]; }
    const T& operator[](std::size_t i) const { return chunks_[i >> shift][i & (chunk - 1)]; }
    void push_back(T value) {
        free_memory(1);
        (*this)[size_++] = value;
    }
    /// Appends `count` elements that are copied from an array.
    void append(const T* values, std::size_t count) {
        free_memory(count);
        for (std::size_t done = 0; done != count;) {
            const std::size_t at = size_ & (chunk - 1);
            const std::size_t now = std::min(count - done, chunk - at);
            std::copy_n(values + done, now, chunks_[size_ >> shift].get() + at);
            done += now;
            size_ += now;
        }
    }
    /// Ensures that the next `count` calls of `push_back` do not allocate memory.
    void free_memory(std::size_t count) {
        while (chunks_.size() * chunk < size_ + count) chunks_.push_back(std::make_unique_for_overwrite<T[]>(chunk));
    }
    void pop_back() { --size_; }
    T& back() { return (*this)[size_ - 1]; }
    void assign(std::size_t size, T value) {
        clear();
        while (size_ < size) push_back(value);
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t bytes() const { return chunks_.size() * chunk * sizeof(T); }
    void clear() {
        chunks_.clear();
        size_ = 0;
    }

private:
    std::vector<std::unique_ptr<T[]>> chunks_ = {};
    std::size_t size_ = 0;
};

}  // namespace grafverif::timed
