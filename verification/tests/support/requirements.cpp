#include "support/requirements.hpp"

#include <gtest/gtest.h>

#include <toml++/toml.h>
#include <algorithm>
#include <functional>
#include <map>

namespace stickslip::testing {

namespace {

const std::vector<Requirement> table{
    // The problem and its data.
    {"P1",
     "The problem types, case files and overrides take what is allowed and refuse everything else by name.",
     "Sect. 3, parameters",
     {"ProblemTypes", "NumericalSettings", "Beam", "Damping", "CaseFile", "PublishedCases", "PaperCase",
      "Override", "ShortestText", "InputLimits"}},
    {"P2",
     "The friction coefficient falls from mu_s at rest to mu_m with the decay alpha.",
     "Eqs. (6), (7); Fig. 2",
     {"FrictionLaw"}},
    {"P3",
     "What the paper prints is kept with its digits, units and places.",
     "All printed numbers",
     {"PrintedNumbers", "PrintedVerdicts", "Unstated", "MalformedPaperFile", "MalformedClaimsFile"}},
    {"P4",
     "The two implementations share the problem statement and nothing else.",
     "Design",
     {"Independence"}},
    {"P5",
     "Reference data are read as published; whatever is altered, missing or inconsistent in them, and in "
     "files to be "
     "compared with them, is refused at its place.",
     "Data package",
     {"ReferenceReader", "ReferenceKeys", "UserTable", "ColumnMapping"}},
    {"P6",
     "The published data are what the code makes, each number with its uncertainty and its provenance.",
     "Data package",
     {"PublishedData", "PublishedDataLong"}},

    // Closed form.
    {"A1",
     "The quasi-static shape S solves its equation and boundary conditions.",
     "Eqs. (12) to (18); Fig. 8",
     {"QuasiStaticShape"}},
    {"A2",
     "Natural frequencies and modes of the stick state are all roots of the characteristic equation.",
     "Eqs. (20), (22), (23); Fig. 7; E1, E2, E5",
     {"StickModes"}},
    {"A3",
     "Natural frequencies and modes of the slip state are those of a cantilever under a follower load.",
     "Eq. (5); Fig. 7; E8",
     {"SlipModes", "AdjointSlipModes", "FlutterLoad"}},
    {"A4",
     "The closed-form response satisfies the equation of motion, its boundary and its initial conditions.",
     "Eqs. (1) to (3), (24) to (28); E3, E4",
     {"StickResponse"}},
    {"A5",
     "The maximum of the friction force is enclosed from both sides.",
     "Sect. 5; Fig. 10; E6",
     {"MaximumForce", "SampledMaximum", "Enclosures", "ForceMaximum", "ModalReaction", "ModalReactionTable"}},
    {"A6",
     "The criterion compares the maximum with mu_s P; the critical amplitude brings it there.",
     "Eqs. (29), (30); Fig. 11",
     {"Criterion"}},
    {"A7",
     "The steady vibration with Kelvin-Voigt damping solves its boundary value problem, tip held or free.",
     "Complex modulus",
     {"DampedSteadyState"}},
    {"A8",
     "The closed forms of both states in ball arithmetic hold what is true and say so with a proven radius.",
     "Eqs. (16) to (30)",
     {"CertifiedReal", "CertifiedRoots", "CertifiedStickModes", "CertifiedSlipModes", "CertifiedResponse",
      "CertifiedMaximum", "CertifiedCriterion", "CertifiedTipMobility"}},

    {"A9",
     "The mobility of the tip has the poles, zeros and limits of the beam and solves its boundary value "
     "problem; "
     "that of the mesh converges to it with order 4.",
     "Eqs. (1), (2), (5)",
     {"TipMobility", "TipMobilityOrder"}},

    // Finite elements and time stepping.
    {"F1",
     "The element matrices are the integrals of the shape functions and pass the patch tests.",
     "Eqs. (8) to (11)",
     {"BeamElement"}},
    {"F2",
     "The assembled beam has the exact static answers and, in slip, the follower term.",
     "Eqs. (8), (9); E8",
     {"BeamModel", "ModalAnalysis", "StaticShapeOrder"}},
    {"F3",
     "Frequencies and shapes of both states and the flutter load converge with order 4 and the predicted "
     "constant.",
     "Fig. 7; E5, E8",
     {"StickFrequencyOrder", "SlipFrequencyOrder", "StickShapeOrder", "SlipShapeOrder", "FlutterLoadOrder"}},
    {"F4",
     "The reaction from the balance of the tip's row converges with order 4.",
     "Eqs. (4), (9)",
     {"ReactionOrder"}},
    {"F5",
     "Generalised-alpha has the published weights, amplification and second order.",
     "Chung and Hulbert (1993)",
     {"GeneralizedAlpha", "GeneralizedAlphaOrder"}},
    {"F6",
     "Stick, slip and their changes follow the exact histories of one and two masses.",
     "Eqs. (3) to (7), Sect. 3; SDND104",
     {"StickSlipIntegrator", "ShakenPlaneBenchmark", "SlipOrder", "ContactLocation", "ContactHistoryOrder",
      "ContactSchemeOrder", "ContactScheme"}},
    {"F11",
     "Fast runs in the modes of the mesh have the numbers of the plain ones, up to rounding.",
     "Sect. 3",
     {"ModalStickRun", "HeldTipBasis", "ModalStickSlipIntegrator"}},
    {"F7",
     "The simulation of the beam hands its settings on and reports in the fixed frame.",
     "Sect. 3; Fig. 1",
     {"BeamSimulation", "NormalForce"}},
    {"F8",
     "Energy books balance: what no entry explains is the error of the method.",
     "Energy balance",
     {"EnergyBooks", "GeometricEnergy", "ContactChanges", "EnergyResidual", "EnergyResidualOfTheBeam",
      "StickEnergy", "EnergyAudit"}},
    {"F9",
     "Damping matrices dissipate what they are to dissipate, alike in stick and slip.",
     "Kelvin-Voigt; modal",
     {"DampingMatrix", "FreeDecay"}},

    {"F10",
     "A manufactured motion, under the load and the tip force that it implies, comes back with the orders "
     "and the "
     "constants of theory.",
     "Eqs. (1), (3), (5) to (9)",
     {"ManufacturedSpace", "ManufacturedTime"}},

    // From event to event.
    {"D1",
     "The event-driven engine returns the exact histories of one and two masses.",
     "SDND104; exact solutions",
     {"EventDriven", "HeldMode", "HeldModeNearResonance", "DampedHeldMode", "StickPropagatorOf",
      "RippledForce", "ShakenPlane", "ShakenPlaneFrictionPower"}},
    {"D2",
     "The modal models of the beam have its frequencies, energies and shapes and converge to it.",
     "Eqs. (3), (5)",
     {"BeamContactModel", "FreeContactFrequencies", "TruncatedHistory"}},
    {"D3",
     "Event-driven histories of the beam keep their books and do not depend on who asks.",
     "Energy balance",
     {"EventDrivenBeam", "EventDrivenBeamEnergy"}},

    {"D4",
     "The boundary integral and the free modes return the exact histories of one and two masses, and the "
     "same "
     "histories of the beam.",
     "Boundary integral; SDND104; exact solutions",
     {"BoundaryIntegral", "BoundaryIntegralOfAShakenPlane", "GaussStages", "BeamBoundaryIntegral",
      "ConvergedHistory"}},

    // One implementation against the other.
    {"X1",
     "Displacement and force of the stick state agree to the predicted errors of mesh and step.",
     "Eqs. (27), (28); Fig. 9",
     {"StickState", "Figure9", "Figure9Refined", "Figure9RefinedOnceMore"}},
    {"X2",
     "The maximum of the friction force of finite elements is the predicted one.",
     "Sect. 5; E6",
     {"ForceMaximumAt", "ForceMaximumOfTheFlatSection", "SteppedFromRest"}},
    {"X3",
     "Both classify excitations alike outside the predicted guard band.",
     "Figs. 11, 12",
     {"Figure12", "Figure12Finer"}},
    {"X4", "The critical amplitude by search is that of one linear run.", "Fig. 6", {"CriticalAmplitude"}},
    {"X5", "The first slip happens when the closed form says so.", "Eq. (4); Figs. 4, 5", {"FirstSlip"}},
    {"X6",
     "The motion of the whole beam is that of the closed form until the first slip.",
     "Fig. 3",
     {"BeamMotion", "BeamMotionAt"}},
    {"X7",
     "Length and axial force decide as the criterion and finite elements say.",
     "Fig. 14; E9",
     {"LengthForceMap", "ResonanceLength", "CriterionMap", "MapAxis", "MapShare"}},
    {"X8",
     "Damped vibration agrees with the closed form in amplitude and phase.",
     "Complex modulus",
     {"DampedFrequencyResponse", "DampedSteppedResponse", "ModalDamping"}},
    {"X9",
     "Damped stick-slip histories of both implementations converge to one another.",
     "Damped benchmark",
     {"FiniteElementContactModel", "EventDrivenAndStepped", "TimeStepper", "MeshedHistory", "DampedBenchmark",
      "DampedBenchmarkLong", "EventDrivenBeamFiner", "OrderThroughEvents", "ContactSchemeOrderOfTheBeam",
      "EventDifferences", "MicroSticks"}},
    {"X10",
     "The stick-slip history obeys symmetry, units and the friction limit, and stays bounded.",
     "Eqs. (4) to (7)",
     {"StickSlipBeam", "StickSlipBeamLong"}},
    {"X11",
     "The contact schemes, that of the paper among them, do what the report says of them.",
     "Sect. 3",
     {"ContactSchemes"}},
    {"X12",
     "The bound of the growth of a disturbance is that of theory in each discretisation, and runs obey it; "
     "undamped histories converge where it stays bounded under refinement.",
     "Figs. 4, 5",
     {"ContactMobility", "SteppedMobility", "Weakening", "ContactGrowth", "FilteringStep",
      "BoundaryIntegralGrowth", "HistoryConvergence", "HistoryConvergenceLong"}},
    {"X13",
     "Observed orders come with intervals that mean what they say.",
     "Student's t",
     {"OrderEstimate", "OrderBound", "OrderCriterion"}},

    {"X14",
     "What moves the printed maxima, and how many of their digits are determined, is stated by enclosures.",
     "Sect. 5; E6",
     {"ForceSensitivity", "CommonDigits"}},
    {"X15",
     "The smallest margin over a band, resonances included, and what avoids slipping are found to the stated "
     "bound.",
     "Sect. 5, guideline; Fig. 14",
     {"BandMaximum", "BandMargin", "DesignScan"}},

    {"X16",
     "The grid convergence index covers the true error wherever the levels are asymptotic.",
     "Roache (1994)",
     {"GridConvergenceIndex", "SolutionVerification"}},
    {"X17",
     "Named wrong models differ from the reference where they claim to and are recognised by their results; "
     "others "
     "are not blamed.",
     "Sects. 2 to 5; E1 to E4",
     {"WrongModels", "WrongModelsIn", "WrongModel", "ReferenceResultsOf", "Diagnosis", "StickSums"}},
    {"X18",
     "What neither implementation can model both refuse, and nothing else.",
     "Eqs. (4), (23); buckling",
     {"Refusals"}},
    {"X21",
     "Warnings begin where flutter, resonance, shear and rotary inertia, the time step, or the growth of "
     "rounding do, and the estimates in them are right.",
     "Euler-Bernoulli; Beck; generalised-alpha",
     {"ProblemWarnings", "ThickBeam", "LongStep", "ModesThatMatter", "Resonance", "Flutter",
      "GrowthWarning"}},
    {"X19",
     "Doubles agree with the proven enclosures to the last places that their condition leaves.",
     "Eqs. (16) to (30)",
     {"EnclosedFrequencies", "EnclosedShapes", "EnclosedResponse", "EnclosedMaximum", "EnclosedTipMobility"}},

    {"X20",
     "A comparison with reference data agrees with a copy, finds an error of known size, keeps events and "
     "phases apart, "
     "and names a known mistake.",
     "Data package; Sects. 2 to 5",
     {"ComparedCopy", "ComparedTable", "ComparedCurve", "ComparedVerdict", "ComparedEvents",
      "ComparedHistory", "ComparedUndamped", "ComparedUndampedLong", "LikenedTo", "LikenedToNothing"}},

    // Whatever the beam is.
    {"M1",
     "Random beams keep symmetry, units, similarity, superposition, time shift and the order of the "
     "criterion.",
     "Eqs. (1) to (9), (29), (30)",
     {"Symmetry", "UnitChange", "Similarity", "Linearity", "TimeShift", "Monotony"}},
    {"M2",
     "Random beams keep the theorems on nested meshes, Rayleigh quotients, constraints and reciprocity.",
     "Eqs. (8), (9); Ritz, Cauchy, Betti",
     {"MeshNesting", "RayleighBound", "Interlacing", "Reciprocity"}},

    // The paper.
    {"V1", "Verdicts on the eight panels are the printed ones.", "Figs. 4, 5", {"Verdict"}},
    {"V2", "Errata: the corrected text agrees where the printed one does not.", "E1 to E13", {"Errata"}},
    {"V3",
     "Every claim of the paper has a verdict that a measurement gives.",
     "Ledger of claims",
     {"Claim*", "LedgerOfClaims"}},

    // What people use.
    {"U1",
     "The command line prints what the implementations return and refuses bad input in one sentence.",
     "Commands",
     {"CommandLine", "CommandAnswers", "Animation", "MapCommand", "DesignCommand", "ReferenceCommand",
      "CompareCommand", "WarningsOf"}},
    {"U2",
     "Every key, option and column with every defect is refused in one sentence, or taken and gives finite "
     "numbers; every key and column of a published package likewise.",
     "Bad input",
     {"InputMatrix", "CaseFileInput", "ColumnInput", "ColumnsOf", "PackageInput", "PublishedColumns",
      "PackageKeys", "OptionInput", "OptionsOf"}},
    {"U3",
     "Figures and report appear whole or not at all, are drawn from their CSV files alone, and only when "
     "something has changed.",
     "Report",
     {"ReportOutput", "ReportFigures", "ReportStore", "DrawnFigures", "CsvTable"}},
    {"U4",
     "Numbers and notation are typeset without loss.",
     "Report",
     {"LatexNotation", "LatexEscape", "ReportNumber", "FixedNumber", "SignificantNumber",
      "ScientificNumber"}},
    {"U5",
     "The report's sources hold no result: all numbers come from studies.",
     "Report",
     {"ReportSources", "ReportFigureScripts", "LiteralResults"}},
    {"U6",
     "Every test is traced to a requirement and every requirement to tests.",
     "Traceability",
     {"Traceability", "Trace", "TestResults", "PaperIndex"}},
    {"U8",
     "What the benchmarks measured is kept and shown as it was.",
     "Benchmarks",
     {"SpeedRecord", "SpeedRecordFile", "SpeedTables"}},
    {"U9",
     "Help, manual page, completion and tutorial say what the program does.",
     "Documentation",
     {"HelpExamples", "ManualPage", "BashCompletion", "Tutorial"}},
    {"U10",
     "Maps made by any number of threads, shards and interrupted runs are the same bytes; long work shows "
     "how "
     "far it is and ends in good order.",
     "Commands",
     {"MapShards", "ProgressOf", "ProgressStyle", "InParallel", "ThreadCount"}},
    {"U11",
     "Any input is taken or refused in one sentence: no bytes crash, hang or give a number that is not "
     "finite.",
     "Fuzz targets",
     {"FuzzTarget"}},
    {"U12",
     "Full disks, closed pipes, missing programs, signals and runs that diverge leave no file that is not "
     "whole, "
     "and a clear sentence.",
     "Faults",
     {"Fault", "Interrupted", "KilledRun", "KilledRunLong", "Typesetting", "WholeReport"}},
    {"U13",
     "The same input gives the same bytes, in every locale.",
     "Reproducibility",
     {"Reproducible", "LocaleWithAComma"}},
};

}  // namespace

const std::vector<Requirement>& requirements() {
  static const std::vector<Requirement> rows = read_requirements();
  return rows;
}

bool add_suite(const std::string& suite, const std::string& id) {
  const auto [stated, is_first] = ids_of_suites().emplace(suite, id);
  if (stated->second != id) stated->second += " and " + id;  // is no requirement, so that the tests fail
  return is_first;
}

std::string requirement_of(std::string_view suite) {
  suite.remove_prefix(suite.find('/') == std::string_view::npos ? 0 : suite.find('/') + 1);
  const auto stated = ids_of_suites().find(suite);
  return stated == ids_of_suites().end() ? "" : stated->second;
}

void record_requirement(const std::string& id) {
  const auto& rows = requirements();
  const auto row = std::ranges::find(rows, id, &Requirement::id);
  if (row == rows.end()) {
    ADD_FAILURE() << (id.empty() ? "the suite states no requirement: STICKSLIP_VERIFIES is missing"
                                 : "verification/requirements.toml has no requirement " + id);
    return;
  }
  ::testing::Test::RecordProperty("requirement", row->id);
  ::testing::Test::RecordProperty("requirement_position", std::to_string(row - rows.begin()));
  ::testing::Test::RecordProperty("requirement_text", row->text);
  ::testing::Test::RecordProperty("source", row->source);
}

}  // namespace stickslip::testing
