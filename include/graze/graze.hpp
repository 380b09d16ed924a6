// All of Graze's core in one include.
#pragma once

#include "graze/batch.hpp"
#include "graze/batch_raycast.hpp"
#include "graze/broad_phase.hpp"
#include "graze/cast.hpp"
#include "graze/contact.hpp"
#include "graze/contact_motion.hpp"
#include "graze/error.hpp"
#include "graze/filter.hpp"
#include "graze/geometry.hpp"
#include "graze/pairs.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "graze/shape.hpp"
#include "graze/swept.hpp"
#include "graze/trace.hpp"
#include "graze/wide.hpp"
