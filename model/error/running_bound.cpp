#include "model/error/running_bound.hpp"
