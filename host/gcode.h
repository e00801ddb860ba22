/* gcode.h - the drawing for a Grbl-like controller (.gcode).
 *
 * Millimetres, absolute, origin at the lower left corner of the paper. The pen is the spindle output, as on Grbl
 * plotters with a servo or a solenoid: `M3 S1000` lowers, `M5` lifts, each followed by a dwell (`G4 P` seconds) of
 * the machine's pen delay. Travel is `G0`; drawing is `G1` at the machine's drawing speed. A pen on a Z axis wants
 * three replacements: `M3 S1000` by `G1 Z0`, `M5` by `G0 Z5`, and no dwell. */
#ifndef GCODE_H
#define GCODE_H

#include "host/stroke_file.h"

extern const stroke_format_t GCODE_FORMAT;

#endif
