// What turns a number into a verdict on a paper's claim. Set before the numbers were looked at;
// where the papers say "agrees" or "slightly" and no more, the threshold is this harness's reading
// of the word.
#pragma once

namespace slosh::claim_thresholds {

// "The same period": over the 12 s, nearly ten periods, that Li et al.'s figure 1 shows, 2 % shift
// the wave by a fifth of a period, which the eye does not miss.
inline constexpr double same_period = 0.02;

// "Slightly below theory": at most a fifth.
inline constexpr double slightly_below = 0.2;

// "Flattened crests": a cos t + c cos 2t has the skewness 2.1 c / a and crests 1 + 2 c / a times as
// high as its troughs are deep; -0.05 against theory's are crests that are 5 % flatter.
inline constexpr double flattened_skewness = -0.05;

// "Far above linear theory's validity": three times the tenth of the depth up to which the
// small-amplitude case lets linear theory gate.
inline constexpr double violent_elevation_over_depth = 0.3;

// "Crests higher than troughs are deep": clearly so at a quarter, not at all at equality.
inline constexpr double crest_over_trough = 1.25;

// A peak "at" a frequency: within 2 %. Two printed digits of 0.77 Hz are +-0.7 %, the spectrum's
// peak is right to 0.3 %, and 2.3 % away is the 0.787 Hz that the paper also prints.
inline constexpr double peak_frequency = 0.02;

// "Grows", "faster": by a tenth at least. No interval of a spectral peak's power is known.
inline constexpr double growth = 1.1;

// A printed ratio of powers is met within a factor of two: the ratio is free of the unknown unit,
// but not of the spectrum's window, of which the paper says nothing.
inline constexpr double printed_ratio_factor = 2;

// "Agrees in phase": three times the digitised record's 0.03 s at 2 rad/s.
inline constexpr double agreeing_lag_degrees = 10;

// "Agrees in shape": the record exceeds linear theory's amplitude by 14 %, and digitising errs by
// up to 2 % of its largest value, 3.6 kPa, which is 28 % of its rms of 0.255 kPa; independent of
// one another they make hypot(0.14, 0.28) = 0.31.
inline constexpr double agreeing_shape = 0.35;

// "The same": curves that differ by a tenth of their rms lie on one another in a figure.
inline constexpr double same_history = 0.1;

// An impact "at" its time: within a twentieth of the period.
inline constexpr double impact_time_over_period = 0.05;

// A plateau that "agrees": within a quarter.
inline constexpr double agreeing_plateau = 0.25;

// A peak "agrees" within the repeats' central 90 %: quantiles of 5 and 95 %, or where the table is
// not supplied as many standard deviations of a normal distribution. One of four may lie outside:
// four of four would be asked too much, since of four repeats of the experiment itself all lie
// inside in 66 % of all cases, at least three in 95 %.
inline constexpr double repeats_low = 5, repeats_high = 95;  // [%]
inline constexpr double repeats_deviations = 1.645;
inline constexpr int peaks_that_may_miss = 1;

// "More stable", "converges better": smaller by a fifth at least; a fifth to the other side speaks
// against it, and between them the two ways are alike.
inline constexpr double clearly_smaller = 0.8;

}  // namespace slosh::claim_thresholds
