//! Small mathematics shared by all floors.
