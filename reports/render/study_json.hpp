// SPDX-License-Identifier: MIT
#pragma once

/// The results of studies as JSON, for the templates of the report.

#include "render/json_text.hpp"
#include "render/study_results.hpp"

namespace stickslip::data {
NLOHMANN_JSON_SERIALIZE_ENUM(ClaimVerdict, {{ClaimVerdict::holds, "holds"},
                                            {ClaimVerdict::holds_with_correction, "holds with correction"},
                                            {ClaimVerdict::does_not_hold, "does not hold"},
                                            {ClaimVerdict::not_determined, "not determined"}})
STICKSLIP_JSON(Beam, length(), area(), second_moment_of_area(), density(), youngs_modulus(), axial_force())
STICKSLIP_JSON(FrictionLaw, static_coefficient(), kinetic_coefficient(), decay())
STICKSLIP_JSON(HarmonicExcitation, frequency_hz(), amplitude())
STICKSLIP_JSON(NumericalSettings, elements(), time_step(), spectral_radius(), velocity_threshold(), modes(),
               duration())
STICKSLIP_JSON(Case, beam, friction, excitation, numerics)
inline void to_json(nlohmann::json& text, ContactState state) { text = name_of(state); }
inline void to_json(nlohmann::json& text, ContactChange change) { text = name_of(change); }
STICKSLIP_JSON(ContactEvent, change, time, position)
STICKSLIP_JSON(PrintedNumber, id, value, unit, printed, printed_unit, place, meaning)
}  // namespace stickslip::data

namespace stickslip::analytic {
STICKSLIP_JSON(Bounds, lower, upper, midpoint())
STICKSLIP_JSON(FrequencyBand, from_hz, to_hz)
STICKSLIP_JSON(EventDrivenEnergy, kinetic, potential, base_work, follower_work, damping_loss, friction_loss)
}  // namespace stickslip::analytic

namespace stickslip::solver {
STICKSLIP_JSON(EnergyBalance, kinetic, elastic, base_work, follower_work, damping_loss, friction_loss,
               capture_loss, initial_energy, residual())
}  // namespace stickslip::solver

namespace stickslip::studies {
STICKSLIP_JSON(OrderEstimate, order, half_width, levels)

NLOHMANN_JSON_SERIALIZE_ENUM(ManufacturedTip, {{ManufacturedTip::stick, "stick"},
                                               {ManufacturedTip::slip, "slip"},
                                               {ManufacturedTip::friction, "slip, friction law"}})
NLOHMANN_JSON_SERIALIZE_ENUM(CellState, {{CellState::stick, "stick"},
                                         {CellState::stick_slip, "stick-slip"},
                                         {CellState::no_stick_state, "no stick state"}})

STICKSLIP_JSON(FrequencyConvergence, mode, closed_form_hz, finite_element_hz, relative_error, predicted_error,
               observed_order, leading_constant_ratio)
STICKSLIP_JSON(FrequencyStudy, elements, modes)
STICKSLIP_JSON(FlutterStudy, closed_form, elements, finite_element, observed_order)
STICKSLIP_JSON(ModeShapeStudy::Curve, mode, slip, closed_form_hz, finite_element_hz, closed_form,
               finite_element, largest_difference)
STICKSLIP_JSON(ModeShapeStudy, position, curves)
STICKSLIP_JSON(TimeOrderStudy, spectral_radius, time_step, displacement_error, velocity_error, reaction_error,
               displacement_order, velocity_order, reaction_order)
STICKSLIP_JSON(PredictedErrors, error, predicted, floor, order, over_predicted())
STICKSLIP_JSON(ManufacturedSpaceErrors, tip, load_factor, elements, element_length, deflection, slope,
               curvature, tip_deflection, force)
STICKSLIP_JSON(ManufacturedTimeErrors, tip, load_factor, spectral_radius, time_step, displacement, velocity,
               force)
STICKSLIP_JSON(ManufacturedSolutionStudy, space, time)

STICKSLIP_JSON(StickHistoryLevel, elements, time_step, displacement_error, force_error,
               predicted_displacement_error, predicted_force_error)
STICKSLIP_JSON(StickHistoryStudy, displacement_peak, force_peak, levels, displacement_order, force_order,
               predicted_displacement_order, predicted_force_order, time, displacement, force,
               first_displacement, first_force)
STICKSLIP_JSON(ForceMaximumStudy, frequency_hz, amplitude, sampled, truncated, converged, finite_element,
               predicted_finite_element, prediction_uncertainty)
STICKSLIP_JSON(CriticalAmplitudePoint, frequency_hz, critical_amplitude)
STICKSLIP_JSON(CriticalAmplitudeSearch, frequency_hz, searched, runs, linear, stepped_linear, agree())
STICKSLIP_JSON(ClassifiedPoint, frequency_hz, amplitude, closed_form_slips, finite_element_slips,
               in_guard_band)
STICKSLIP_JSON(ClassifiedFrequency, frequency_hz, critical_amplitude, relative_truncation_error,
               relative_discretisation_error, relative_guard())
STICKSLIP_JSON(ClassificationStudy, frequencies, points, agreeing, in_guard_band, disagreeing_outside)
STICKSLIP_JSON(LengthForceMap::Line, axial_force, buckling_length, resonance_1, resonance_2, length,
               force_ratio)
STICKSLIP_JSON(LengthForceMap, lines)
STICKSLIP_JSON(CriterionMap::Cell, x, y, force_ratio, state)
STICKSLIP_JSON(CriterionMap, cells)

STICKSLIP_JSON(HistoryRow, time, tip_displacement, friction_force, state, displacement)
STICKSLIP_JSON(History, rows, events)
STICKSLIP_JSON(BeamMotionStudy, frequency_hz, amplitude, position, finite_element, reference, half_width,
               first_slip, peak, stick_difference, predicted_stick_difference, difference)
STICKSLIP_JSON(ConvergedStick, begin, end, position, begin_half_width, end_half_width, position_half_width)
STICKSLIP_JSON(HistoryLevel, method, time_step, modes, changes, difference)
STICKSLIP_JSON(ConvergedHistory, frequency_hz, amplitude, time, tip, midspan, tip_half_width,
               midspan_half_width, tip_range, midspan_range, first_stick, sticks, levels,
               largest_half_width())
STICKSLIP_JSON(ContactHistory, frequency_hz, amplitude, converged, finite_element_slip, closed_form_slip,
               criterion_slips)
STICKSLIP_JSON(PracticeRun, method, elements, time_step, spectral_radius, changes, largest_error,
               tip_displacement)
STICKSLIP_JSON(StepRule, name, angle, time_step, spectral_radius, radiating_share)
STICKSLIP_JSON(HistoryRun, elements, time_step, spectral_radius, highest_angle, growth_bound, observed_growth,
               error, changes)
STICKSLIP_JSON(HistoryRefinement, rule, frequency_hz, runs, order)
STICKSLIP_JSON(EventDifference, time, position)
STICKSLIP_JSON(BenchmarkRun, method, size, time_step, first_ten, all, each)
STICKSLIP_JSON(DampedBenchmark, frequency_hz, amplitude, kelvin_voigt, duration, shortest_stick, modes,
               events, uncertainties, tolerance_effect, history, runs)
STICKSLIP_JSON(EventOrder, event_time_error, event_position_error, tip_error, event_time_order,
               event_position_order, tip_order)
STICKSLIP_JSON(EventOrderStudy, spectral_radius, elements, events, duration, time_step, located,
               at_end_of_step)
STICKSLIP_JSON(EnergyAudit::Mesh, elements, stepped, observed_order)
STICKSLIP_JSON(EnergyAudit, kelvin_voigt, duration, modes, event_driven, event_driven_initial, time_step,
               meshes, event_driven_residual())
STICKSLIP_JSON(Plateau, begin, end, tip_displacement)
STICKSLIP_JSON(SchemeRun, first_slip, events, plateaus, largest_tip_displacement, energy, relative_residual())

STICKSLIP_JSON(ForceRow, factor, setting, closed_form, left_open, force, change)
STICKSLIP_JSON(InputSensitivity, input, relative, lowest_change, highest_change)
STICKSLIP_JSON(ForceRange, force, digits, holds_printed)
STICKSLIP_JSON(ForceDigits, frequency_hz, printed, half_digit, formula, method, problem, uncertainty,
               verdict())
STICKSLIP_JSON(SamplingTrial, modes, sampling_step, force, largest_difference, returned)
STICKSLIP_JSON(SamplingSearch, most_modes, sampling_steps, returning_all, closest, most_returned)
STICKSLIP_JSON(ForceSensitivity, frequency_hz, rows, inputs, digits, search)
STICKSLIP_JSON(GridConvergence, observed_order, asymptotic, extrapolated, safety_factor, index)
STICKSLIP_JSON(VerificationLevel, elements, time_step, value)
STICKSLIP_JSON(VerifiedResult, id, quantity, unit, printed, levels, convergence, reference, true_error,
               covered, uncertainty, obtained)
STICKSLIP_JSON(SolutionVerification, ratio, formal_order, results)
STICKSLIP_JSON(Resonance, mode, frequency_hz)
STICKSLIP_JSON(BandMargin, force_max, friction_limit, margin, frequency_hz, evaluations, resonances)
STICKSLIP_JSON(DesignInterval, from, to, sticks, buckled, resonances)
STICKSLIP_JSON(DesignScan, accuracy, intervals)
STICKSLIP_JSON(Design, band, margin, lengths, forces)
STICKSLIP_JSON(ForceHorizon, duration, force_max)
STICKSLIP_JSON(SteadyForce, frequency_hz, amplitude, steady, grows, horizons)
STICKSLIP_JSON(SteadyDampedForce, frequency_hz, amplitude, ratio, undamped_force_max, steady)
STICKSLIP_JSON(SlenderForce, frequency_hz, model_errors, force_max, shifted_force_max)
STICKSLIP_JSON(SofterBeam, larger, all, lowest_ratio, at_hz)
STICKSLIP_JSON(LateSlips, range, settled, later_range)
STICKSLIP_JSON(Scope, friction_limit, steady, damped, slender, softer, late_slips)
STICKSLIP_JSON(AxialDirectionPlane, figures, lost, lowest_ratio, highest_ratio, flipped_share(),
               buckled_share())
STICKSLIP_JSON(AxialDirectionForce, frequency_hz, ratio)
STICKSLIP_JSON(ModelPlane, figures, lost, flipped_share())
STICKSLIP_JSON(ModelForm, forces, planes, shear)
STICKSLIP_JSON(ModelVariant, stiffness_ratio, damping_ratio)
STICKSLIP_JSON(VariantPlane, variant, lost, flipped_share())
STICKSLIP_JSON(PrintedCheck, printed, computed, method, allowed, because, left_open, error(), verdict(),
               agrees())
STICKSLIP_JSON(ErratumEvidence, erratum, quantity, unit, as_printed, corrected, reference, tolerance,
               confirmed())
}  // namespace stickslip::studies

namespace stickslip::comparison {

STICKSLIP_JSON(WrongModel, name, mistake, place)
STICKSLIP_JSON(WrongModelEffect, wrong_model, stick_frequency, slip_frequency, force_maximum, stick_force,
               stick_displacement, first_slip, tip_displacement)

}  // namespace stickslip::comparison
