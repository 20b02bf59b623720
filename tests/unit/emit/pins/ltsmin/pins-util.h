/* SPDX-License-Identifier: MIT */
#include <ltsmin/pins.h>
