#!/usr/bin/env python3
"""Plane shocks in Wilbeck's porous liquid (1978, AFML-TR-77-134), by bisection for the pressure in 50 decimal digits. Standard library only.

    rho0/rho = (1 - z)(p/A + 1)^(-1/B) + z (p/p0 + 1)^(-1/1.4),  A = rho_l c_l^2/B,  B = 4k - 1,  p gauge
    p1 (1 - rho0/rho1) = rho0 v^2,  U_s = v/(1 - rho0/rho1),  c1^2 = dp/drho

Prints tests/data/hugoniot_porous.csv.
"""
from decimal import Decimal as D
from decimal import getcontext

getcontext().prec = 50
LIQUID, SOUND, SLOPE, AMBIENT, GAMMA = D(1000), D(1480), D(2), D(101325), D("1.4")
AIR = AMBIENT / (D("287.05") * D("288.15"))
B = 4 * SLOPE - 1
A = LIQUID * SOUND**2 / B


def volume(p, z):
    return (1 - z) * (p / A + 1) ** (-1 / B) + z * (p / AMBIENT + 1) ** (-1 / GAMMA)


def shock(z, v):
    rho0 = (1 - z) * LIQUID + z * AIR
    low, high = D(0), D(10) ** 12
    for _ in range(150):
        p = (low + high) / 2
        low, high = (low, p) if p * (1 - volume(p, z)) > rho0 * v * v else (p, high)
    V = volume(p, z)
    slope = -(1 - z) / (A * B) * (p / A + 1) ** (-1 / B - 1) - z / (AMBIENT * GAMMA) * (p / AMBIENT + 1) ** (-1 / GAMMA - 1)
    # c^2 = dp/drho, rho = rho0/V: drho = -rho0/V^2 dV
    c1 = (-V * V / (rho0 * slope)).sqrt()
    return rho0, 1 / V, p, v / (1 - V), c1


if __name__ == "__main__":
    print("porosity,density_kg_m3,speed_m_s,density_ratio,hugoniot_pressure_Pa,shock_speed_m_s,sound_speed_behind_m_s")
    for z in ("0", "0.02", "0.1", "0.15", "0.4"):
        for v in ("5", "50", "116", "177.4", "300", "500"):
            rho0, ratio, p, Us, c1 = shock(D(z), D(v))
            print(f"{z},{rho0:.10f},{v},{ratio:.10f},{p:.6f},{Us:.8f},{c1:.8f}")
