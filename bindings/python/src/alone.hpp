// The guard of a world or a simulation against calls that meet.
//
// Guarantee: while a call changes the thing, any other use of it raises RuntimeError, and while a call reads it, any
// change does, instead of reading a state that is half written. Calls meet where one releases the interpreter's lock,
// and where a shape's support function, written in Python, is run in the middle of one. The counts are read and written
// with the lock held, so they need no other.
#pragma once

#include "convert.hpp"

namespace graze::python {

class Alone {
 public:
  /// A read of a thing: others may read it too as long as this lives.
  template <class Thing>
  class Reading {
   public:
    Reading(const Thing& thing, const Alone& alone) : thing_(&thing), alone_(&alone) {
      if (alone.changing_) throw std::runtime_error("in use: another call changes it at this moment");
      ++alone.readers_;
    }
    ~Reading() { --alone_->readers_; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    const Thing* operator->() const { return thing_; }
    const Thing& operator*() const { return *thing_; }

   private:
    const Thing* thing_;
    const Alone* alone_;
  };

  /// A change of a thing: nobody else may use it as long as this lives.
  template <class Thing>
  class Changing {
   public:
    Changing(Thing& thing, const Alone& alone) : thing_(&thing), alone_(&alone) {
      if (alone.changing_) throw std::runtime_error("in use: another call changes it at this moment");
      if (alone.readers_ != 0) throw std::runtime_error("in use: another call reads it at this moment");
      alone.changing_ = true;
    }
    ~Changing() { alone_->changing_ = false; }
    Changing(const Changing&) = delete;
    Changing& operator=(const Changing&) = delete;
    Thing* operator->() const { return thing_; }
    Thing& operator*() const { return *thing_; }

   private:
    Thing* thing_;
    const Alone* alone_;
  };

 private:
  mutable std::size_t readers_ = 0;
  mutable bool changing_ = false;
};

}  // namespace graze::python
