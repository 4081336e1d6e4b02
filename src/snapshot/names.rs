//! Columns, and how they are called in HDF5.

/// A quantity: the stem of our columns, its dataset in our files (GADGET's name), and what other codes call it.
pub struct Known {
    pub stem: &'static str,
    pub dataset: &'static str,
    pub others: &'static [&'static str],
}

const fn known(stem: &'static str, dataset: &'static str, others: &'static [&'static str]) -> Known {
    Known { stem, dataset, others }
}

/// The dataset of positions, and that of ids.
pub const COORDINATES: &str = "Coordinates";
pub const IDS: &str = "ParticleIDs";

/// Those that have a name everywhere. The others are SWIFT's and GIZMO's.
pub const KNOWN: &[Known] = &[
    known("velocity", "Velocities", &["Velocity"]),
    known("mass", "Masses", &["Mass"]),
    known("density", "Density", &["Densities"]),
    known("internal_energy", "InternalEnergy", &["InternalEnergies"]),
    known("pressure", "Pressure", &["Pressures"]),
    known("smoothing_length", "SmoothingLength", &["SmoothingLengths", "Hsml"]),
    known("acceleration", "Acceleration", &["Accelerations"]),
    known("sound_speed", "SoundSpeed", &["SoundSpeeds"]),
];

/// The dataset of a stem: `smoothing_length` is `SmoothingLength`.
pub fn dataset_of(stem: &str) -> String {
    if let Some(known) = KNOWN.iter().find(|known| known.stem == stem) {
        return known.dataset.into();
    }
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase().to_string() + letters.as_str()).unwrap_or_default()
    };
    stem.split('_').map(capital).collect()
}

/// The stem of a dataset of any code: `SmoothingLengths` is `smoothing_length`.
pub fn stem_of(dataset: &str) -> String {
    let known = KNOWN.iter().find(|known| known.dataset == dataset || known.others.contains(&dataset));
    if let Some(known) = known {
        return known.stem.into();
    }
    let mut stem = String::new();
    let mut before: Option<char> = None;
    for letter in dataset.chars() {
        // A capital begins a word, but not within an abbreviation.
        if letter.is_ascii_uppercase() && before.is_some_and(|b| b.is_ascii_lowercase() || b.is_ascii_digit()) {
            stem.push('_');
        }
        stem.push(if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' });
        before = Some(letter);
    }
    stem
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_to_and_fro() {
        for stem in ["velocity", "smoothing_length", "kernel_normalisation", "mobility", "grad_h", "volume"] {
            assert_eq!(stem_of(&dataset_of(stem)), stem);
        }
        for (dataset, stem) in [
            ("Densities", "density"),
            ("Hsml", "smoothing_length"),
            ("SmoothingLengths", "smoothing_length"),
            ("ElectronAbundance", "electron_abundance"),
            ("VelocityDivergences", "velocity_divergences"),
            ("AGNFlag", "agnflag"),
            ("X-ray", "x_ray"),
        ] {
            assert_eq!(stem_of(dataset), stem);
        }
    }
}
